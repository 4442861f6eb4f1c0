/** Any task, for property tests of challenges and lessons. */
import { conditionNames, editKinds, type Goal } from "@corridor/challenge";
import { arbitraryMaze } from "@corridor/maze/testing";
import { arbitraryProgram } from "@corridor/program/testing";
import { plainActions, sensorNames } from "@corridor/protocol";
import fc from "fast-check";
import type { TaskFields } from "../task-coder.ts";

export const anyText = (max: number) => fc.string({ unit: "binary", maxLength: max });
export const anyList = <Name>(names: readonly Name[], minLength = 0) =>
  fc.uniqueArray(fc.constantFrom(...names), { minLength });
const distance = fc.double({ min: 1, max: 50_000, noNaN: true });

const anyGoal: fc.Arbitrary<Goal> = fc.oneof(
  fc.constantFrom<Goal>({ kind: "reach" }, { kind: "visit" }),
  fc.record({ kind: fc.constant("drive" as const), distance }),
  fc.record({ kind: fc.constant("last" as const), seconds: fc.integer({ min: 1, max: 20 }) }),
  fc.tuple(fc.constantFrom(...sensorNames), distance, distance).map(([sensor, a, b]): Goal => ({
    kind: "stop",
    sensor,
    from: Math.min(a, b),
    to: Math.max(a, b),
  })),
);

/** @param maxSeconds of the checks */
export const arbitraryTask = (maxSeconds: number): fc.Arbitrary<TaskFields> =>
  fc.record({
    name: anyText(60),
    words: fc.record({
      task: anyText(120),
      short: anyText(60),
      hints: fc.array(anyText(80), { maxLength: 4 }),
    }),
    mazes: fc.array(
      arbitraryMaze.map((maze) => ({
        ...maze,
        goals: [{ column: maze.start.column, row: maze.start.row }],
      })),
      { minLength: 1, maxLength: 3 },
    ),
    program: fc.option(arbitraryProgram),
    goal: anyGoal,
    allowed: fc.record({
      drivers: anyList(["me", "program", "remote"] as const, 1),
      lines: fc.constant(200),
      conditions: fc.option(anyList(conditionNames)),
      actions: fc.option(anyList(plainActions)),
      edits: anyList(editKinds),
      maze: fc.boolean(),
    }),
    checks: fc.record({
      bumps: fc.option(fc.integer({ min: 0, max: 1_000 })),
      seconds: fc.integer({ min: 20, max: maxSeconds }),
    }),
    par: fc.option(
      fc.record({
        lines: fc.integer({ min: 0, max: 200 }),
        seconds: fc.double({ min: 0, max: 600, noNaN: true }),
      }),
    ),
  });
