import type { CommandRecord, RemoteCommand } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { commandText, cutShortAfter } from "../../text/command-text.ts";
import { viewConnection } from "./connection-view.ts";
import { maskKey, robotAddress } from "../../model/remote/robot-address.ts";

describe("a command in the list", () => {
  it.each<{ command: RemoteCommand; text: string }>([
    { command: { action: "left 90" }, text: "left 90" },
    { command: { action: "move", distance: 120 }, text: "move 120" },
    { command: { action: "turn", degrees: -45.5 }, text: "turn -45.5" },
    { command: { action: "drive", left: 0.2, right: -0.2 }, text: "drive 0.2 -0.2" },
    {
      command: { action: "drive", left: 1, right: 0, milliseconds: 602 },
      text: "drive 1 0 602 ms",
    },
    {
      command: { action: "forward", until: [{ sensor: "front", is: "<=", than: 60 }] },
      text: "forward until front <= 60",
    },
    {
      command: {
        action: "reverse",
        until: [{ sensor: "left", is: ">", than: "right", plus: -1 }, { goal: true }],
      },
      text: "reverse until left > right - 1, …",
    },
    {
      command: { action: "drive", left: 0.5, right: 0.4, until: [{ goal: true }] },
      text: "drive 0.5 0.4 until goal",
    },
  ])("reads $text", ({ command, text }) => {
    expect(commandText(command)).toBe(text);
  });

  it.each<{ state: CommandRecord["state"]; distance: number | null; after: number | null }>([
    { state: "collided", distance: 223.6, after: 224 },
    { state: "cancelled", distance: 12, after: 12 },
    { state: "superseded", distance: 0.2, after: null },
    { state: "completed", distance: 100, after: null },
    { state: "accepted", distance: null, after: null },
  ])("that is $state after $distance cm shows $after", ({ state, distance, after }) => {
    expect(cutShortAfter({ state, distance })).toBe(after);
  });
});

describe("the connection", () => {
  it.each([
    { silence: 300, view: { kind: "connected", client: "Python", seconds: 0.3 } },
    { silence: 4_999, view: { kind: "connected", client: "Python", seconds: 4.999 } },
    { silence: 12_000, view: { kind: "quiet", client: "Python", seconds: 12 } },
    { silence: -50, view: { kind: "connected", client: "Python", seconds: 0 } },
  ])("is $view.kind when the script sent its last request $silence ms ago", ({ silence, view }) => {
    const status = { kind: "connected", client: "Python", seenAt: 1_000_000 } as const;
    expect(viewConnection(status, false, 1_000_000 + silence)).toEqual(view);
  });

  it("reports that the run is paused, not that the script is inactive", () => {
    const connected = { kind: "connected", client: "Python", seenAt: 1_000 } as const;
    expect(viewConnection(connected, true, 10_000)).toEqual({ kind: "paused" });
    expect(viewConnection({ kind: "waiting" }, true, 10_000)).toEqual({ kind: "paused" });
  });

  it("passes on what needs no clock", () => {
    expect(viewConnection({ kind: "lost", reason: "noService" }, true, 0)).toEqual({
      kind: "lost",
      reason: "noService",
    });
  });
});

describe("the robot's address", () => {
  const session = { id: "abc", ownerKey: "o", driverKey: "secret-key", lastApplied: 0 };

  it.each([
    { origin: "http://localhost:1234", url: "http://localhost:1234/r/abc" },
    { origin: "https://robots.school", url: "https://robots.school/r/abc" },
  ])("is displayed as a URL without its key, and names the API: $url", ({ origin, url }) => {
    const address = `${origin}/r/abc#secret-key`;
    expect(robotAddress({ ...session, address })).toEqual({
      full: address,
      shown: url,
      api: `${origin}/api/v1/robots/abc`,
      key: "secret-key",
    });
  });

  it("is refused when it is none", () => {
    expect(robotAddress({ ...session, address: "nonsense" })).toBeNull();
  });

  it.each([
    { key: "d_Hq7sd2fk7js9f2kd7Q4D", mask: "•••• •••• 7Q4D" },
    { key: "short", mask: "•••• •••• ••••" },
  ])("has a key that is shown as $mask", ({ key, mask }) => {
    expect(maskKey(key)).toBe(mask);
  });
});
