import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { isProgramRefused, runOrPause, startHint, stepBack, stepOn } from "./run-button.ts";

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
      expect(runOrPause({ snapshot: snapshotOf({ driver, state }), view: "now" })).toEqual({
        type,
      });
    },
  );

  it.each(["me", "program", "remote"] as const)(
    "is run from here while a moment is shown at which %s drove, and pause while it plays on",
    (driver) => {
      const paused = snapshotOf({ driver, state: "paused" });
      expect(runOrPause({ snapshot: paused, view: "past" })).toEqual({ type: "run-here" });
      const played = snapshotOf({ driver, state: "running" });
      expect(runOrPause({ snapshot: played, view: "playing" })).toEqual({ type: "pause" });
    },
  );

  it("is run before the first snapshot", () => {
    expect(runOrPause({ snapshot: null, view: "now" })).toEqual({ type: "run" });
  });
});

describe("Run and Step", () => {
  it.each([
    { drivers: ["me"] as const, isOff: true },
    { drivers: ["me", "program"] as const, isOff: false },
    { drivers: ["program"] as const, isOff: false },
  ])("are off where only $drivers may drive: $isOff", ({ drivers, isOff }) => {
    expect(isProgramRefused({ drivers: [...drivers] })).toBe(isOff);
  });

  it("are on without a challenge", () => {
    expect(isProgramRefused(null)).toBe(false);
  });
});

describe("Step", () => {
  it("takes a decision now, and shows the next one of those taken in the past", () => {
    const snapshot = snapshotOf({ tick: 40 });
    expect(stepOn({ view: "now", snapshot })).toEqual({ type: "step", length: "decision" });
    expect(stepOn({ view: "past", snapshot })).toEqual({ type: "seek-step", by: 1 });
    expect(stepOn({ view: "playing", snapshot })).toEqual({ type: "seek-step", by: 1 });
    expect(stepBack({ snapshot })).toEqual({ type: "seek-step", by: -1 });
  });

  it("goes by one tick forward and back where that is asked for", () => {
    const snapshot = snapshotOf({ tick: 40 });
    expect(stepOn({ view: "now", snapshot }, "tick")).toEqual({ type: "step", length: "tick" });
    expect(stepOn({ view: "past", snapshot }, "tick")).toEqual({ type: "seek", tick: 41 });
    expect(stepBack({ snapshot }, "tick")).toEqual({ type: "seek", tick: 39 });
    expect(stepBack({ snapshot: snapshotOf({ tick: 0 }) }, "tick")).toEqual({
      type: "seek",
      tick: 0,
    });
  });
});

describe("the hint before a run", () => {
  it.each([
    { drivers: null, hint: "hint" },
    { drivers: ["program"] as const, hint: "hint" },
    { drivers: ["me", "program"] as const, hint: "hint" },
    { drivers: ["me"] as const, hint: "byHand" },
    { drivers: ["me", "remote"] as const, hint: "byHand" },
    { drivers: ["remote"] as const, hint: "byScript" },
  ])("is $hint where $drivers may drive", ({ drivers, hint }) => {
    expect(startHint(drivers && { drivers })).toBe(hint);
  });
});
