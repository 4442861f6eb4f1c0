import { closeReasons } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import type { HttpRequest } from "./platform.ts";
import { FakePlatform } from "./testing/fake-platform.ts";
import { WatchConnection } from "./watch-connection.ts";

const ID = "A".repeat(22);
const KEY = `wch_${"A".repeat(22)}`;
const VERSION = "k3J9x2aBk3J9x2aBk3J9x2";

/** A viewer, and a relay whose responses the test controls. */
function watching() {
  const platform = new FakePlatform();
  const requests: HttpRequest[] = [];
  const respond: ((status: number, body?: string) => Promise<void>)[] = [];
  const log: string[] = [];
  const request = (sent: HttpRequest) => {
    requests.push(sent);
    const { promise, resolve } = Promise.withResolvers<{ status: number; body: string }>();
    respond.push(async (status, body = "") => {
      resolve({ status, body });
      await promise;
      await Promise.resolve();
    });
    return { response: promise, cancel: () => log.push("cancelled") };
  };
  const connection = new WatchConnection({
    origin: "https://host",
    id: ID,
    key: KEY,
    onSnapshot: ({ seq }) => log.push(`snapshot ${seq}`),
    onMaze: (text) => log.push(`maze ${text}`),
    onStatus: ({ kind }) => log.push(kind),
    platform: Object.assign(platform, { request }),
  });
  const welcome = (): void => {
    platform.socket.open();
    const start = { stream: "AAAAAAAA", n: 0, snapshot: snapshotOf({ seq: 7 }) };
    platform.socket.receive({ type: "welcome", version: 1, ...start });
  };
  return { platform, requests, respond, log, connection, welcome };
}

describe("a viewer", () => {
  it("sends its role, receives the snapshot, and requests the maze with the key in the header", () => {
    const { platform, log, requests, welcome } = watching();
    welcome();
    expect(platform.socket.sent).toEqual([
      { type: "hello", version: 1, role: "watch", key: KEY },
      { type: "seen", seq: 7 },
    ]);
    expect(log).toEqual(["connecting", "snapshot 7", "connected"]);
    const url = `https://host/api/v1/robots/${ID}/maze`;
    expect(requests).toEqual([{ method: "GET", url, key: KEY, body: null }]);
  });

  it("receives every snapshot, and acknowledges every second one", () => {
    const { platform, log, welcome } = watching();
    welcome();
    for (const seq of [8, 9]) {
      platform.pass(50);
      platform.socket.receive({ type: "snapshot", snapshot: snapshotOf({ seq }) });
      expect(log.at(-1)).toBe(`snapshot ${seq}`);
    }
    expect(platform.socket.sent.slice(1)).toEqual([
      { type: "seen", seq: 7 },
      { type: "seen", seq: 9 },
    ]);
  });

  it("receives the maze, and the next one after a change", async () => {
    const { platform, log, respond, requests, welcome } = watching();
    welcome();
    await respond[0]?.(200, "first");
    expect(log.at(-1)).toBe("maze first");
    platform.socket.receive({ type: "maze", version: VERSION });
    platform.socket.receive({ type: "maze", version: VERSION.toUpperCase() });
    expect(requests).toHaveLength(3);
    // Of two requests only the newer one counts.
    await respond[1]?.(200, "second");
    await respond[2]?.(200, "third");
    expect(log.filter((entry) => entry.startsWith("maze"))).toEqual(["maze first", "maze third"]);
  });

  it("receives null if the maze is unknown, and retries if the relay fails", async () => {
    const { platform, log, respond, requests, welcome } = watching();
    welcome();
    await respond[0]?.(503);
    expect(log.at(-1)).toBe("connected");
    platform.pass(2_000);
    expect(requests).toHaveLength(2);
    await respond[1]?.(404);
    expect(log.at(-1)).toBe("maze null");
    platform.pass(10_000);
    expect(requests).toHaveLength(2);
  });

  it("requests the maze again after each reconnect, because it may have changed", () => {
    const { platform, requests, welcome } = watching();
    welcome();
    platform.socket.cut(1012);
    platform.pass(1_000);
    welcome();
    expect(requests).toHaveLength(2);
  });

  it("ends permanently when its key is revoked", () => {
    const { platform, log, welcome } = watching();
    welcome();
    platform.socket.cut(closeReasons.notAuthorised.code);
    platform.pass(60_000);
    expect(log.slice(-2)).toEqual(["cancelled", "over"]);
    expect(platform.sockets).toHaveLength(1);
  });

  it("closes without a status, and opens again", () => {
    const { platform, log, connection, welcome } = watching();
    welcome();
    connection.close();
    platform.pass(60_000);
    expect(log.slice(-2)).toEqual(["connected", "cancelled"]);
    connection.open();
    expect(platform.sockets).toHaveLength(2);
  });
});
