import { closeReasons } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { StudentConnection } from "./student-connection.ts";
import type { HttpRequest } from "./platform.ts";
import { FakePlatform } from "./testing/fake-platform.ts";

const ID = "A".repeat(22);
const KEY = `stu_${"A".repeat(22)}`;
const hello = { type: "hello", version: 1, role: "learn", key: KEY };
const welcomeMessage = {
  type: "welcome",
  version: 1,
  student: 3,
  name: { word: 17, text: null },
  renamesLeft: 2,
  progress: 0,
  helpWanted: false,
  watched: false,
  pauseEndsInMs: null,
  paceTo: null,
  lesson: "k3J9x2aBk3J9x2aBk3J9x2",
};

/** A student, and a relay whose responses the test controls. */
function learning(platform: FakePlatform = new FakePlatform()) {
  const log: string[] = [];
  const connection = new StudentConnection({
    origin: "https://host",
    id: ID,
    key: KEY,
    onMessage: ({ type }) => log.push(type),
    onStatus: (status) =>
      log.push("reason" in status ? `${status.kind} ${status.reason.code}` : status.kind),
    platform,
  });
  const welcome = (): void => {
    platform.socket.open();
    platform.socket.receive(welcomeMessage);
  };
  return { platform, log, connection, welcome };
}

describe("a student in a class", () => {
  it("sends its role and key to the class, and receives the welcome first", () => {
    const { platform, log, connection, welcome } = learning();
    expect(connection.isConnected).toBe(false);
    welcome();
    expect(platform.socket.url).toBe(`wss://host/api/v1/classes/${ID}/socket`);
    expect(platform.socket.sent).toEqual([hello]);
    expect(log).toEqual(["connecting", "welcome", "connected"]);
    expect(connection.isConnected).toBe(true);
  });

  it("receives what the teacher does, and no heartbeats or unknown messages", () => {
    const { platform, log, welcome } = learning();
    welcome();
    platform.socket.receive({ type: "heartbeat" });
    platform.socket.receive({ type: "confetti" });
    platform.socket.receive({ type: "watched", watched: true });
    platform.socket.receive({ type: "pause", endsInMs: 60_000 });
    expect(log.slice(3)).toEqual(["watched", "pause"]);
  });

  it("asks for help while it is connected", () => {
    const { platform, connection, welcome } = learning();
    connection.send({ type: "help", wanted: false });
    welcome();
    connection.send({ type: "help", wanted: true });
    expect(platform.socket.sent).toEqual([hello, { type: "help", wanted: true }]);
  });

  it("reconnects after a lost network, at once if asked to", () => {
    const { platform, log, connection, welcome } = learning();
    welcome();
    platform.socket.cut(1006);
    expect(log.at(-1)).toBe("lost 1006");
    connection.open();
    welcome();
    expect(platform.sockets).toHaveLength(2);
    expect(log.slice(-3)).toEqual(["connecting", "welcome", "connected"]);
  });

  it.each([
    { why: "the teacher removed the student", code: closeReasons.forbidden.code },
    { why: "the key is not valid any more", code: closeReasons.notAuthorised.code },
    { why: "another tab took over", code: closeReasons.replaced.code },
    { why: "the class has ended", code: closeReasons.over.code },
  ])("ends permanently when $why", ({ code }) => {
    const { platform, log, connection, welcome } = learning();
    welcome();
    platform.socket.cut(code);
    connection.open();
    platform.pass(60_000);
    expect(log.at(-1)).toBe(`over ${code}`);
    expect(platform.sockets).toHaveLength(1);
  });

  it("uses long polling where the network blocks WebSockets, and ends when the class has", async () => {
    const requests: HttpRequest[] = [];
    const request = (sent: HttpRequest) => {
      requests.push(sent);
      const body = JSON.stringify({ type: "/problems/no-class" });
      return { response: Promise.resolve({ status: 404, body }), cancel: () => undefined };
    };
    const { platform, log } = learning(Object.assign(new FakePlatform(), { request }));
    platform.socket.cut(1006);
    platform.pass(0);
    await expect.poll(() => log.at(-1)).toBe(`over ${closeReasons.over.code}`);
    expect(requests).toMatchObject([
      { method: "POST", url: `https://host/api/v1/classes/${ID}/long-poll`, key: null },
    ]);
  });

  it("closes without a status", () => {
    const { platform, log, connection, welcome } = learning();
    welcome();
    connection.close();
    platform.pass(60_000);
    expect(log.at(-1)).toBe("connected");
    expect(platform.socket.isClosed).toBe(true);
  });
});
