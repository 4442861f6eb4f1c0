import type { Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { runOrPause } from "./run-button.ts";

const snapshot: Snapshot = {
  seq: 1,
  tick: 1,
  state: "paused",
  driver: "program",
  sensors: { front: 50, right: 50, back: 50, left: 50 },
  pose: { x: 50, y: 50, heading: 0 },
  motion: "stop",
  bumps: 0,
  bumping: false,
  goalReached: false,
  line: null,
  command: null,
};

describe("runOrPause", () => {
  it.each([
    { driver: "program", state: "paused", type: "run" },
    { driver: "program", state: "running", type: "pause" },
    { driver: "remote", state: "running", type: "pause" },
    { driver: "remote", state: "paused", type: "run" },
    { driver: "me", state: "paused", type: "run" },
    { driver: "me", state: "running", type: "run" },
  ] as const)(
    "is $type while $driver drives and the robot is $state",
    ({ driver, state, type }) => {
      expect(runOrPause({ ...snapshot, driver, state })).toEqual({ type });
    },
  );

  it("is run before the first snapshot", () => {
    expect(runOrPause(null)).toEqual({ type: "run" });
  });
});
