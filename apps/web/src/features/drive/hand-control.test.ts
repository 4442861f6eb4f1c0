import { snapshotOf } from "@corridor/protocol/testing";
import { describe, expect, it } from "vitest";
import { handAction, type HandAction, type HandRun } from "./hand-control.ts";

const now = (snapshot: Parameters<typeof snapshotOf>[0]): HandRun => ({
  snapshot: snapshotOf(snapshot),
  view: "now",
  nowDriver: snapshotOf(snapshot).driver,
  fault: null,
});
const firstScreen = now({ tick: 0, driver: "program", state: "paused" });
const replay = (
  view: "past" | "playing",
  driver: "me" | "program",
  nowDriver: "me" | "program",
) => ({
  ...now({ tick: 60, driver, state: view === "past" ? "paused" : "running" }),
  view,
  nowDriver,
});

interface Row {
  state: string;
  run: HandRun;
  drivers?: ("me" | "program" | "remote")[];
  drive: HandAction;
  stop: HandAction;
}

const rows: Row[] = [
  { state: "on the first screen", run: firstScreen, drive: "take-over", stop: "none" },
  {
    state: "before the first frame",
    run: { snapshot: null, view: "now", nowDriver: null, fault: null },
    drive: "take-over",
    stop: "none",
  },
  {
    state: "while the program runs",
    run: now({ tick: 60, driver: "program", state: "running" }),
    drive: "take-over",
    stop: "pause",
  },
  {
    state: "while the program is paused",
    run: now({ tick: 60, driver: "program", state: "paused" }),
    drive: "take-over",
    stop: "none",
  },
  {
    state: "after a bump",
    run: now({ tick: 60, driver: "program", state: "paused", bumps: 1, bumping: true }),
    drive: "take-over",
    stop: "none",
  },
  {
    state: "after the goal",
    run: now({ tick: 60, driver: "program", state: "paused", goalReached: true }),
    drive: "take-over",
    stop: "none",
  },
  {
    state: "while a script drives",
    run: now({ tick: 60, driver: "remote", state: "running" }),
    drive: "take-over",
    stop: "pause",
  },
  {
    state: "while the hand drives",
    run: now({ tick: 60, driver: "me", state: "running" }),
    drive: "drive",
    stop: "drive",
  },
  {
    state: "while the hand rests",
    run: now({ tick: 60, driver: "me", state: "paused" }),
    drive: "drive",
    stop: "drive",
  },
  {
    state: "at an earlier moment of the program's",
    run: replay("past", "program", "program"),
    drive: "take-over",
    stop: "none",
  },
  {
    state: "at an earlier moment of the program's, in a run that a hand took over later",
    run: replay("past", "program", "me"),
    drive: "take-over",
    stop: "none",
  },
  {
    state: "at an earlier moment of the hand's",
    run: replay("past", "me", "me"),
    drive: "drive",
    stop: "none",
  },
  {
    state: "while the past is played",
    run: replay("playing", "me", "me"),
    drive: "drive",
    stop: "pause",
  },
  {
    state: "in a mission for the program, after Reset",
    run: firstScreen,
    drivers: ["program"],
    drive: "refuse",
    stop: "none",
  },
  {
    state: "in a mission for the program, where a restored run was driven by hand",
    run: now({ driver: "me", state: "paused" }),
    drivers: ["program"],
    drive: "refuse",
    stop: "drive",
  },
  {
    state: "in a mission for hand and program, after Run and Reset",
    run: firstScreen,
    drivers: ["me", "program"],
    drive: "take-over",
    stop: "none",
  },
  {
    state: "in a mission for hand and program, while the program runs",
    run: now({ tick: 9, driver: "program", state: "running" }),
    drivers: ["me", "program"],
    drive: "take-over",
    stop: "pause",
  },
  {
    state: "when the simulator stopped for good",
    run: { ...firstScreen, fault: "broken" },
    drive: "none",
    stop: "none",
  },
];

describe("a drive key", () => {
  it.each(rows)("$state: drives by $drive, Stop by $stop", ({ run, drivers, drive, stop }) => {
    const rights = drivers === undefined ? null : { drivers };
    for (const key of ["forward", "reverse", "left", "right"] as const)
      expect(handAction(key, run, rights)).toBe(drive);
    expect(handAction("stop", run, rights)).toBe(stop);
  });
});
