import type { ProgramDocument } from "@corridor/program";
import type { Snapshot } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { createRunStore, type RunState } from "../../model/run/run-store.ts";
import type { RunEvent } from "../../simulator/protocol/worker-messages.ts";
import { RunListener, type RunAnnouncement } from "./run-listener.ts";

const program: ProgramDocument = {
  format: "corridor/program",
  version: 1,
  name: "Right wall",
  rules: [
    { when: { sensor: "right", is: ">", than: 60 }, do: "delayed right 90" },
    { when: { sensor: "front", is: "<", than: 50 }, do: "left 90" },
  ],
  default: "forward",
};

const still: Snapshot = {
  seq: 0,
  tick: 0,
  sensors: { front: 250, right: 50, back: 50, left: 50 },
  pose: { x: 50, y: 650, heading: 90 },
  motion: "stop",
  bumps: 0,
  bumping: false,
  goalReached: false,
  state: "paused",
  driver: "program",
  line: "default",
  command: null,
};
const fresh: RunState = { ...createRunStore().getInitialState(), snapshot: still };

type Change = Partial<Omit<RunState, "snapshot">> & Partial<Snapshot>;

/** The state after a change. A change combines fields of the snapshot and of the store. */
function after(state: RunState, change: Change): RunState {
  const parts = Object.entries(change);
  const ofSnapshot = Object.fromEntries(parts.filter(([key]) => key in still));
  const ofStore = Object.fromEntries(parts.filter(([key]) => !(key in still)));
  const snapshot = { ...(state.snapshot ?? still), ...ofSnapshot };
  return { ...state, nowTick: snapshot.tick, ...ofStore, snapshot };
}

/** The notes that a sequence of changes produces. */
function noted(...changes: Change[]): (RunAnnouncement | null)[] {
  const listener = new RunListener(fresh);
  let state = fresh;
  return changes.map((change) => {
    state = after(state, change);
    return listener.update(state, program);
  });
}

const bump: RunEvent = {
  kind: "bump",
  tick: 130,
  pose: still.pose,
  line: 1,
  driver: "program",
  bumps: 1,
  cause: null,
  diagnosis: null,
  program: null,
};
const turn = (left: number): RunState["progress"] => ({
  direction: -1,
  action: "left 90",
  part: 0,
  parts: 1,
  kind: "turn",
  left,
  of: 90,
});

describe("RunListener", () => {
  it("notes who drives when the run begins, and nothing while the same line goes on", () => {
    expect(noted({ state: "running", tick: 1 }, { tick: 20 }, { tick: 40 })).toEqual([
      { kind: "decision", line: "default", isTurn: false },
      null,
      null,
    ]);
  });

  it("notes a turn once, from the decision to its end, and the line after it", () => {
    expect(
      noted(
        { state: "running", tick: 1 },
        { tick: 120, line: 1 },
        { tick: 123, progress: turn(80) },
        { tick: 140, progress: turn(20) },
        { tick: 150, progress: null, line: "default" },
      ).slice(1),
    ).toEqual([
      { kind: "decision", line: 1, isTurn: true },
      null,
      null,
      { kind: "decision", line: "default", isTurn: false },
    ]);
  });

  it("notes a second turn of the same line", () => {
    expect(
      noted(
        { state: "running", tick: 1, line: 1, progress: turn(80) },
        { tick: 40, progress: turn(5) },
        { tick: 46, progress: turn(85) },
      ).slice(1),
    ).toEqual([null, { kind: "decision", line: 1, isTurn: true }]);
  });

  it("notes a pause, but not the one that ends a bump, the goal or a Step of one tick", () => {
    const runs: Change = { state: "running", tick: 100 };
    expect(noted(runs, { state: "paused", tick: 101 })[1]).toEqual({ kind: "paused" });
    expect(noted(runs, { state: "paused", tick: 101, bumping: true })[1]).toBeNull();
    expect(noted(runs, { state: "paused", tick: 101, goalReached: true })[1]).toBeNull();
    expect(noted({ state: "running" }, { state: "paused", tick: 1 })[1]).toBeNull();
  });

  it("answers each Step, also when the same line decides again", () => {
    expect(noted({ tick: 1 }, { tick: 2 })).toEqual([
      { kind: "decision", line: "default", isTurn: true },
      { kind: "decision", line: "default", isTurn: true },
    ]);
  });

  it("notes bumps and the goal at every speed, each once", () => {
    expect(
      noted(
        { state: "running", tick: 1, speed: "max" },
        { tick: 130, event: bump },
        { tick: 140 },
        { tick: 900, event: { ...bump, kind: "goal" } },
      ).map((announcement) => announcement?.kind ?? null),
    ).toEqual(["too-fast", "event", null, "event"]);
  });

  it.each([4, 8, 16, "max"] as const)("leaves lines out at speed %s", (speed) => {
    expect(
      noted({ state: "running", tick: 1, speed }, { tick: 120, line: 1 }, { tick: 200, line: 0 }),
    ).toEqual([{ kind: "too-fast" }, null, null]);
  });

  it("announces the line again when the speed decreases", () => {
    expect(
      noted(
        { state: "running", tick: 1, speed: 8 },
        { tick: 120, line: 0 },
        { tick: 130, speed: 1 },
      )[2],
    ).toEqual({ kind: "decision", line: 0, isTurn: true });
  });

  it("announces an earlier tick, each displayed tick, playing and the return", () => {
    expect(
      noted(
        { state: "paused", tick: 500, nowTick: 500 },
        { view: "past", tick: 400, nowTick: 500 },
        { tick: 300, nowTick: 500 },
        { tick: 300, nowTick: 500 },
        { view: "playing", tick: 301, nowTick: 500 },
        { view: "now", tick: 500, nowTick: 500 },
      ).slice(1),
    ).toEqual([
      { kind: "past", isFirst: true },
      { kind: "past", isFirst: false },
      null,
      { kind: "playing" },
      { kind: "now" },
    ]);
  });

  it("notes that the robot is back at its start", () => {
    expect(noted({ state: "running", tick: 90 }, { state: "paused", tick: 0 })[1]).toEqual({
      kind: "at-start",
    });
  });

  it("notes the way back to the start of a run that ended before its first frame", () => {
    expect(noted({ event: bump, tick: 0 }, { event: null }, { seq: 1 })).toEqual([
      { kind: "event", event: bump },
      { kind: "at-start" },
      null,
    ]);
  });

  it("notes nothing while a hand or a script drives", () => {
    expect(
      noted(
        { state: "running", tick: 1, driver: "me", line: null },
        { tick: 50 },
        { state: "paused" },
      ),
    ).toEqual([null, null, null]);
  });
});
