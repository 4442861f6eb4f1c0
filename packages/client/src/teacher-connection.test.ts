import { closeReasons } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { TeacherConnection } from "./teacher-connection.ts";
import { FakePlatform } from "./testing/fake-platform.ts";

const ID = "A".repeat(22);
const KEY = `tea_${"A".repeat(22)}`;
const STREAM = "k3J9x2aB";
const settings = {
  code: "BCDFGH",
  locked: false,
  pauseEndsInMs: null,
  paceTo: null,
  lesson: "k3J9x2aBk3J9x2aBk3J9x2",
};
const tile = {
  seq: 1,
  task: 1,
  maze: "g1",
  state: "driving",
  pose: [150, 150, 90],
  path: "e4s2".repeat(100),
  line: 1,
  tick: 30,
  bumps: 0,
  passes: null,
};

/** A dashboard, and a relay whose messages the test controls. */
function teaching(since: string | null = null) {
  const platform = new FakePlatform();
  const log: string[] = [];
  const connection = new TeacherConnection({
    origin: "https://host",
    id: ID,
    key: KEY,
    since,
    onMessage: ({ type }) => log.push(type),
    onStatus: (status) => log.push(status.kind),
    platform,
  });
  const welcome = (n: number | null): void => {
    platform.socket.open();
    platform.socket.receive({ type: "welcome", version: 1, stream: STREAM, n, settings });
  };
  return { platform, log, connection, welcome };
}

describe("a dashboard", () => {
  it("continues after what it has read of the class", () => {
    const { platform, log, welcome } = teaching(`${STREAM}-4`);
    welcome(4);
    expect(platform.socket.sent).toEqual([
      { type: "hello", version: 1, role: "teach", key: KEY, since: `${STREAM}-4` },
    ]);
    expect(log).toEqual(["connecting", "welcome", "connected"]);
  });

  it("asks only for the events that it missed while the network was lost", () => {
    const { platform, log, connection, welcome } = teaching();
    welcome(4);
    expect(platform.socket.sent[0]).not.toHaveProperty("since");
    platform.socket.receive({ type: "removed", n: 5, student: 1 });
    platform.socket.cut(1006);
    connection.open();
    welcome(null);
    expect(platform.socket.sent).toMatchObject([{ since: `${STREAM}-5` }]);
    platform.socket.receive({ type: "gap", n: 9 });
    expect(log.at(-1)).toBe("gap");
    platform.socket.cut(1006);
    connection.open();
    welcome(9);
    expect(platform.socket.sent).toMatchObject([{ since: `${STREAM}-9` }]);
  });

  it("acknowledges the tiles of a full class", () => {
    const { platform, log, welcome } = teaching();
    welcome(0);
    const tiles = Array.from({ length: 200 }, (_, at) => ({
      student: at + 1,
      connected: true,
      tile,
    }));
    platform.socket.receive({ type: "tiles", seq: 7, tiles });
    expect(log.at(-1)).toBe("tiles");
    expect(platform.socket.sent.at(-1)).toEqual({ type: "seen", seq: 7 });
  });

  it("ends permanently when the class has ended", () => {
    const { platform, log, connection, welcome } = teaching();
    welcome(0);
    platform.socket.cut(closeReasons.over.code);
    connection.open();
    platform.pass(60_000);
    expect(log.at(-1)).toBe("over");
    expect(platform.sockets).toHaveLength(1);
  });
});
