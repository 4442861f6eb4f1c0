import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { runOrPause } from "./run-button.ts";

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
      expect(runOrPause(snapshotOf({ driver, state }))).toEqual({ type });
    },
  );

  it("is run before the first snapshot", () => {
    expect(runOrPause(null)).toEqual({ type: "run" });
  });
});
