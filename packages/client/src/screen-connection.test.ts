import { expect, it } from "vitest";
import { ScreenConnection } from "./screen-connection.ts";
import { FakePlatform } from "./testing/fake-platform.ts";

const KEY = `scr_${"A".repeat(22)}`;

it("a big screen receives large content, and acknowledges it", () => {
  const platform = new FakePlatform();
  const log: unknown[] = [];
  const connection = new ScreenConnection({
    origin: "https://host",
    id: "A".repeat(22),
    key: KEY,
    onMessage: (message) => log.push(message),
    onStatus: () => undefined,
    platform,
  });
  platform.socket.open();
  const welcome = { type: "welcome", version: 1, code: "BCDFGH", lesson: "k3J9x2aBk3J9x2aBk3J9x2" };
  platform.socket.receive(welcome);
  const display = { type: "display", seq: 3, content: { text: "x".repeat(60_000) } };
  platform.socket.receive(display);
  expect(log).toEqual([welcome, display]);
  expect(platform.socket.sent).toEqual([
    { type: "hello", version: 1, role: "show", key: KEY },
    { type: "seen", seq: 3 },
  ]);
  expect(connection.isConnected).toBe(true);
});
