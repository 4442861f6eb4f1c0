import { plainActions } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { openRun } from "./open-run.ts";
import { Recording } from "./recording.ts";
import { readRun } from "./run-schema.ts";
import type { Run } from "./run.ts";
import {
  anyLivelyProgram,
  anyOperations,
  anySmallMaze,
  perform,
  type Operation,
} from "./testing/operations.ts";

/** All displayed values of a run at its current tick. */
function stateOf(run: Run): unknown {
  const { driver, line, command, progress, decidedAt, maze, program } = run;
  return { ...run.report(), driver, line, command, progress, decidedAt, maze, program };
}

/** Performs the operations. Returns the state of the live run at each tick, after its inputs. */
function record(recording: Recording, operations: readonly Operation[]): Map<number, unknown> {
  const live = new Map<number, unknown>();
  const note = () => live.set(recording.run.tick, stateOf(recording.run));
  note();
  for (const operation of operations) {
    perform(recording, operation, note);
    note();
  }
  return live;
}

function fileOf(recording: Recording): string {
  const written = recording.toDocument("any");
  if (!written.ok) throw new Error(written.reason);
  return JSON.stringify(written.run);
}

const anyRun = fc.record({
  maze: anySmallMaze,
  program: anyLivelyProgram,
  operations: anyOperations,
});

describe("a run of any operations", () => {
  it("is replayed from its file bit for bit, and again from the file of the replay", () => {
    let ticks = 0;
    fc.assert(
      fc.property(anyRun, ({ maze, program, operations }) => {
        const recording = new Recording(maze, program);
        record(recording, operations);
        let file = fileOf(recording);
        for (let copy = 0; copy < 2; copy++) {
          const read = readRun(file);
          if (!read.ok) throw new Error(JSON.stringify(read.problems));
          const opened = openRun(read.value);
          if (!opened.ok) throw new Error(JSON.stringify(opened.problems));
          expect(stateOf(opened.value.run)).toEqual(stateOf(recording.run));
          expect(opened.value.run.digest()).toBe(recording.run.digest());
          file = fileOf(opened.value);
        }
        ticks += recording.run.tick;
      }),
      { numRuns: 200 },
    );
    expect(ticks).toBeGreaterThan(10_000);
  });

  it("is played back at any tick as it was live, in any order", () => {
    fc.assert(
      fc.property(
        anyRun,
        fc.array(fc.nat(), { minLength: 1, maxLength: 8 }),
        ({ maze, program, operations }, numbers) => {
          const recording = new Recording(maze, program);
          const live = record(recording, operations);
          const playback = recording.playback();
          for (const number of numbers) {
            const tick = number % (recording.run.tick + 1);
            playback.seek(tick);
            expect(stateOf(playback.run)).toEqual(live.get(tick));
          }
        },
      ),
      { numRuns: 200 },
    );
  });

  it("truncated and continued equals a run of the remaining inputs", () => {
    fc.assert(
      fc.property(
        anyRun,
        fc.nat(),
        anyOperations,
        ({ maze, program, operations }, number, later) => {
          const recording = new Recording(maze, program);
          const live = record(recording, operations);
          const tick = number % (recording.run.tick + 1);
          recording.truncate(tick);
          expect(stateOf(recording.run)).toEqual(live.get(tick));
          record(recording, later);
          const opened = openRun(JSON.parse(fileOf(recording)));
          if (!opened.ok) throw new Error(JSON.stringify(opened.problems));
          const fresh = opened.value;
          expect(fresh.run.digest()).toBe(recording.run.digest());
          const end = recording.run.tick;
          for (const log of ["corners", "bumps"] as const) {
            const count = recording[log].countUpTo(end);
            expect(fresh[log].countUpTo(end)).toBe(count);
            expect(fresh[log].slice(0, count)).toEqual(recording[log].slice(0, count));
          }
        },
      ),
      { numRuns: 200 },
    );
  });

  it("finds the previous and the next decision from any tick", () => {
    fc.assert(
      fc.property(anyRun, fc.nat(), ({ maze, program, operations }, number) => {
        const recording = new Recording(maze, program);
        // Stored by tick, so that an edit that was replaced in the same tick does not count.
        const decided = new Map([[0, 0]]);
        const note = () => decided.set(recording.run.tick, recording.run.decidedAt);
        for (const operation of operations) {
          perform(recording, operation, note);
          note();
        }
        const ticks = [...new Set(decided.values())].toSorted((a, b) => a - b);
        const tick = number % (recording.run.tick + 1);
        const playback = recording.playback();
        expect(recording.decisionBefore(tick, playback)).toBe(
          ticks.findLast((each) => each < tick) ?? 0,
        );
        expect(recording.decisionAfter(tick, playback)).toBe(
          ticks.find((each) => each > tick) ?? null,
        );
      }),
      { numRuns: 200 },
    );
  });
});

describe("decisions of a long straight drive", () => {
  const maze = {
    format: "corridor/maze" as const,
    version: 1 as const,
    name: "corridor",
    blocks: [".".repeat(40)],
    start: { column: 0, row: 0, heading: "east" as const },
    goals: [],
  };
  const program = {
    format: "corridor/program" as const,
    version: 1 as const,
    name: "turn at the end",
    default: "forward" as const,
    rules: [
      { when: { sensor: "front" as const, is: "<" as const, than: 50 }, do: plainActions[5] },
    ],
  };

  it("are one decision, across all keyframes", () => {
    const recording = new Recording(maze, program);
    for (let tick = 0; tick < 6000; tick++) recording.step();
    const playback = recording.playback();
    const turn = recording.decisionAfter(0, playback);
    expect(turn).toBeGreaterThan(2300);
    expect(turn).toBeLessThan(2400);
    const drive = recording.decisionAfter(turn ?? 0, playback);
    expect(drive).toBe((turn ?? 0) + 72);
    expect(recording.decisionBefore(5000, playback)).toBeGreaterThan(4600);
    expect(recording.decisionBefore(turn ?? 0, playback)).toBe(0);
  });
});

describe("a run as a file", () => {
  const open = {
    format: "corridor/maze" as const,
    version: 1 as const,
    name: "Hall",
    blocks: Array.from({ length: 101 }, () => ".".repeat(101)),
    start: { column: 0, row: 0, heading: "east" as const },
    goals: [],
  };
  const still = {
    format: "corridor/program" as const,
    version: 1 as const,
    name: "Still",
    default: "stop" as const,
    rules: [],
  };

  it("is written only if it can be read back", () => {
    const recording = new Recording(open, still);
    let longest = "";
    let refusal: string | null = null;
    let next = 100;
    for (let edits = 1; edits <= 900; edits++) {
      recording.step();
      const blocks = open.blocks.with(100, `${".".repeat(edits % 101)}#`.padEnd(101, "."));
      recording.addInput({ do: "maze", maze: { ...open, blocks } });
      if (edits < next) continue;
      const written = recording.toDocument("Hall");
      refusal = written.ok ? null : written.reason;
      if (!written.ok) break;
      longest = written.text;
      expect(JSON.parse(longest)).toEqual(written.run);
      // All edits add the same. Close to the limit, the file is written after each of them.
      const room = Math.floor((8_300_000 - longest.length) / (longest.length / edits));
      next = edits + Math.min(Math.max(room, 1), 100);
    }
    expect(refusal).toBe("too-long");
    expect(longest.length).toBeGreaterThan(8_300_000);
    expect(readRun(longest).ok).toBe(true);
    expect(recording.toDocument("Hall")).toEqual({ ok: false, reason: "too-long" });
  });
});
