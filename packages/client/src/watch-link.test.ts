import { closeReasons } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import type { HttpRequest } from "./platform.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { WatchLink } from "./watch-link.ts";

const ID = "A".repeat(22);
const KEY = `wch_${"A".repeat(22)}`;
const VERSION = "k3J9x2aBk3J9x2aBk3J9x2";

/** Somebody who looks on, at a relay that answers as it is told. */
function watching() {
  const platform = new FakePlatform();
  const asked: HttpRequest[] = [];
  const answers: ((status: number, body?: string) => Promise<void>)[] = [];
  const told: string[] = [];
  const ask = (request: HttpRequest) => {
    asked.push(request);
    const { promise, resolve } = Promise.withResolvers<{ status: number; body: string }>();
    answers.push(async (status, body = "") => {
      resolve({ status, body });
      await promise;
      await Promise.resolve();
    });
    return { answer: promise, cancel: () => told.push("called off") };
  };
  const link = new WatchLink({
    origin: "https://host",
    id: ID,
    key: KEY,
    onSnapshot: ({ seq }) => told.push(`snapshot ${seq}`),
    onMaze: (text) => told.push(`maze ${text}`),
    onStatus: ({ kind }) => told.push(kind),
    platform: Object.assign(platform, { ask }),
  });
  const welcome = (): void => {
    platform.socket.open();
    const start = { stream: "AAAAAAAA", n: 0, snapshot: snapshotOf({ seq: 7 }) };
    platform.socket.receive({ type: "welcome", version: 1, ...start });
  };
  return { platform, asked, answers, told, link, welcome };
}

describe("who looks on", () => {
  it("says so, is told where the robot is, and asks for its maze with the key in the header", () => {
    const { platform, told, asked, welcome } = watching();
    welcome();
    expect(platform.socket.sent).toEqual([
      { type: "hello", version: 1, role: "watch", key: KEY },
      { type: "seen", seq: 7 },
    ]);
    expect(told).toEqual(["connecting", "snapshot 7", "connected"]);
    const url = `https://host/api/v1/robots/${ID}/maze`;
    expect(asked).toEqual([{ method: "GET", url, key: KEY, body: null }]);
  });

  it("gets every snapshot, and says of every second one that all were read", () => {
    const { platform, told, welcome } = watching();
    welcome();
    for (const seq of [8, 9]) {
      platform.pass(50);
      platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq }) });
      expect(told.at(-1)).toBe(`snapshot ${seq}`);
    }
    expect(platform.socket.sent.slice(1)).toEqual([
      { type: "seen", seq: 7 },
      { type: "seen", seq: 9 },
    ]);
  });

  it("gets the maze, and another one when the robot is in it", async () => {
    const { platform, told, answers, asked, welcome } = watching();
    welcome();
    await answers[0]?.(200, "first");
    expect(told.at(-1)).toBe("maze first");
    platform.socket.receive({ type: "maze", version: VERSION });
    platform.socket.receive({ type: "maze", version: VERSION.toUpperCase() });
    expect(asked).toHaveLength(3);
    // Of two that were asked for only the newer one counts, whichever comes first.
    await answers[1]?.(200, "second");
    await answers[2]?.(200, "third");
    expect(told.filter((words) => words.startsWith("maze"))).toEqual(["maze first", "maze third"]);
  });

  it("is told where nobody knows the maze, and asks again where the relay cannot say", async () => {
    const { platform, told, answers, asked, welcome } = watching();
    welcome();
    await answers[0]?.(503);
    expect(told.at(-1)).toBe("connected");
    platform.pass(2_000);
    expect(asked).toHaveLength(2);
    await answers[1]?.(404);
    expect(told.at(-1)).toBe("maze null");
    platform.pass(10_000);
    expect(asked).toHaveLength(2);
  });

  it("asks for the maze anew with each line, since it may have missed another one", () => {
    const { platform, asked, welcome } = watching();
    welcome();
    platform.socket.cut(1012);
    platform.pass(1_000);
    welcome();
    expect(asked).toHaveLength(2);
  });

  it("ends for good when its key is revoked", () => {
    const { platform, told, welcome } = watching();
    welcome();
    platform.socket.cut(closeReasons.notAuthorised.code);
    platform.pass(60_000);
    expect(told.slice(-2)).toEqual(["called off", "over"]);
    expect(platform.sockets).toHaveLength(1);
  });

  it("is left without a word", () => {
    const { platform, told, link, welcome } = watching();
    welcome();
    link.close();
    platform.pass(60_000);
    expect(told.slice(-2)).toEqual(["connected", "called off"]);
    link.open();
    expect(platform.sockets).toHaveLength(2);
  });
});
