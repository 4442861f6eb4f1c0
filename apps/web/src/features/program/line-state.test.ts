import type { ProgramDocument } from "@corridor/program";
import type { Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { decidingLine, lineStates } from "./line-state.ts";

const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "right 90" },
    { when: null, do: "forward" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ],
};

const snapshot: Snapshot = {
  seq: 1,
  tick: 1,
  state: "running",
  driver: "program",
  sensors: { front: 40, right: 250, back: 50, left: 50 },
  pose: { x: 50, y: 50, heading: 0 },
  motion: "forward",
  bumps: 0,
  bumping: false,
  goalReached: false,
  line: 0,
  command: null,
};

describe("lineStates", () => {
  it("lights the deciding line and passes over all lines below it", () => {
    const states = lineStates(program, snapshot);
    expect(states.map(({ isDeciding }) => isDeciding)).toEqual([true, false, false]);
    expect(states.map(({ isPassedOver }) => isPassedOver)).toEqual([false, true, true]);
  });

  it("tells the truth of every line with a condition, read or not", () => {
    const truths = lineStates(program, snapshot).map(({ truth }) => truth?.isTrue);
    expect(truths).toEqual([true, undefined, true]);
  });

  it("passes over nothing when otherwise decides", () => {
    const states = lineStates(program, { ...snapshot, line: "default" });
    expect(states.some(({ isPassedOver, isDeciding }) => isPassedOver || isDeciding)).toBe(false);
  });

  it.each(["me", "remote"] as const)("lights nothing while %s drives", (driver) => {
    expect(decidingLine({ ...snapshot, driver })).toBeNull();
  });

  it("knows no truth before the first snapshot", () => {
    expect(lineStates(program, null).map(({ truth }) => truth)).toEqual([null, null, null]);
  });
});
