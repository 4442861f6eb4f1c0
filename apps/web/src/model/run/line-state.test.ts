import type { ProgramDocument, Rule } from "@corridor/program";
import type { Snapshot } from "@corridor/protocol";
import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import {
  decidingLine,
  isPassedOver,
  lineStateOf,
  shownBump,
  shownProgress,
  shownTruth,
} from "./line-state.ts";

const rule: Rule = { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" };
const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "",
  default: "forward",
  rules: [rule, rule],
};
const snapshot = snapshotOf({
  driver: "program",
  sensors: { front: 40, right: 250, back: 50, left: 50 },
  motion: "forward",
  line: 0,
});

describe("decidingLine", () => {
  it("is the line that drives", () => {
    expect(decidingLine(snapshot)).toBe(0);
    expect(decidingLine({ ...snapshot, line: "default" })).toBe("default");
  });

  it.each(["me", "remote"] as const)("is none while %s drives", (driver) => {
    expect(decidingLine({ ...snapshot, driver })).toBeNull();
  });

  it("is none before the first snapshot", () => {
    expect(decidingLine(null)).toBeNull();
  });
});

describe("isPassedOver", () => {
  it("is so for all lines below the deciding one, and only for them", () => {
    expect([0, 1, 2].map((index) => isPassedOver(index, 1))).toEqual([false, false, true]);
  });

  it("is so for no line when otherwise decides, or nobody", () => {
    expect(isPassedOver(2, "default")).toBe(false);
    expect(isPassedOver(2, null)).toBe(false);
  });
});

describe("lineStateOf", () => {
  const states = (hasEnded: boolean, of: Partial<Snapshot> = { state: "running" }) =>
    [0, 1, 2].map((index) =>
      lineStateOf(index, rule, {
        snapshot: { ...snapshot, ...of, line: 1 },
        event: null,
        hasEnded,
      }),
    );

  it("is not read below the line that decides", () => {
    expect(states(false)).toEqual(["resting", "running", "notRead"]);
  });

  it("is running only while the robot is", () => {
    expect(states(false, { state: "paused" })).toEqual(["resting", "resting", "notRead"]);
  });

  it("is not read for no line where the run has ended, because no line decides there", () => {
    expect(states(true, { state: "paused" })).toEqual(["resting", "resting", "resting"]);
  });
});

describe("shownTruth", () => {
  it("is known for every condition and every driver", () => {
    const condition = { sensor: "right", is: ">", than: 60 } as const;
    const truth = { isTrue: true, left: "250", right: "> 60" };
    expect(shownTruth(condition, snapshot)).toEqual(truth);
    expect(shownTruth(condition, { ...snapshot, driver: "me", line: null })).toEqual(truth);
  });

  it("is none for a line that does nothing, and before the first snapshot", () => {
    expect(shownTruth(null, snapshot)).toBeNull();
    expect(shownTruth({ sensor: "right", is: ">", than: 60 }, null)).toBeNull();
  });
});

describe("shownProgress", () => {
  const drive = {
    action: "delayed right 90",
    part: 0,
    parts: 3,
    kind: "drive",
    direction: 1,
    left: 35.2,
    of: 50,
  } as const;

  it.each([
    ["the way to a delayed turn", drive, { kind: "approach", left: 36, of: 50 }],
    [
      "the turn",
      { ...drive, part: 1, kind: "turn", left: 66, of: 90 },
      { kind: "turn", left: 66, of: 90 },
    ],
    [
      "the way out",
      { ...drive, part: 2, left: 12.01, of: 60 },
      { kind: "leave", left: 13, of: 60 },
    ],
    [
      "a distance but for rounding",
      { ...drive, left: 36.0000000001 },
      { kind: "approach", left: 36, of: 50 },
    ],
  ] as const)("counts down %s", (_, progress, expected) => {
    expect(shownProgress(0, { snapshot, progress })).toEqual(expected);
  });

  it("is none for another line, without a manoeuvre, and while another drives", () => {
    expect(shownProgress(1, { snapshot, progress: drive })).toBeNull();
    expect(shownProgress(0, { snapshot, progress: null })).toBeNull();
    const mine = { ...snapshot, driver: "me" as const };
    expect(shownProgress(0, { snapshot: mine, progress: drive })).toBeNull();
  });
});

describe("shownBump", () => {
  const touching = { ...snapshot, bumping: true, bumps: 2, tick: 80 };
  const event = {
    kind: "bump" as const,
    line: 0,
    bumps: 2,
    cause: {
      decidedAt: 55,
      startedAt: 55,
      action: "delayed right 90" as const,
      readings: touching.sensors,
      part: 0,
      parts: 3,
      side: "front" as const,
      reading: 49,
      driven: 23.9,
      needed: 50,
    },
    diagnosis: {
      event: { kind: "late" as const, tick: 80 },
      cause: {
        kind: "delayed" as const,
        side: "right" as const,
        needs: 75,
        moment: {
          tick: 55,
          line: 0,
          when: null,
          action: "delayed right 90" as const,
          readings: touching.sensors,
        },
      },
      fixes: [],
    },
    program,
  };

  it("is that of the line that caused it, as long as the robot touches it", () => {
    expect(shownBump(0, rule, { snapshot: touching, event })).toEqual({ driven: 24, needed: 50 });
    expect(shownBump(1, rule, { snapshot: touching, event })).toBeNull();
    const free = { ...touching, bumping: false };
    expect(shownBump(0, rule, { snapshot: free, event })).toBeNull();
  });

  it("is that of another line than the one that drove where that one is the cause", () => {
    const other = { ...event, line: "default" as const };
    expect(shownBump(0, rule, { snapshot: touching, event: other })).toEqual({
      driven: null,
      needed: null,
    });
    expect(shownBump("default", "forward", { snapshot: touching, event: other })).toBeNull();
  });

  it("has no distance for a motion that other lines may have chosen before", () => {
    const cause = { ...event.cause, action: "forward" as const, driven: 425, needed: null };
    expect(shownBump(0, rule, { snapshot: touching, event: { ...event, cause } })).toEqual({
      driven: null,
      needed: null,
    });
  });

  it("stays with that line when another one decides beside the wall", () => {
    const next = { ...touching, line: 1 };
    expect(shownBump(0, rule, { snapshot: next, event })).not.toBeNull();
    expect(shownBump(1, rule, { snapshot: next, event })).toBeNull();
  });

  it("ends when the line is changed, because the new one did not bump", () => {
    const state = { snapshot: touching, event };
    expect(shownBump(0, { ...rule, do: "left 90" }, state)).toBeNull();
    expect(shownBump(0, { ...rule }, state)).not.toBeNull();
  });

  it("marks no line for a bump whose cause is not known", () => {
    const past = { ...touching, bumps: 1, tick: 30 };
    expect(shownBump(0, rule, { snapshot: past, event })).toBeNull();
    expect(shownBump(0, rule, { snapshot: touching, event: null })).toBeNull();
  });

  it("belongs to no line during manual driving", () => {
    const mine = { ...touching, driver: "me" as const, line: null };
    expect(shownBump(0, rule, { snapshot: mine, event })).toBeNull();
  });
});
