import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { mazeKinds } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import { arbitraryProgram } from "@corridor/program/testing";
import fc from "fast-check";
import { afterAll, describe, expect, it } from "vitest";
import {
  mazeOf,
  minutesFor,
  tryMaze,
} from "../../../apps/web/src/simulator/pool-worker/maze-trial.ts";

const folder = mkdtempSync(join(tmpdir(), "corridor-trial-"));
afterAll(() => rmSync(folder, { recursive: true }));

/** Output of the command line for the same maze and program. */
function simulate(maze: unknown, program: unknown, minutes: number, until: "goal" | "bump") {
  const files = { maze: join(folder, "maze.json"), program: join(folder, "program.json") };
  writeFileSync(files.maze, JSON.stringify(maze));
  writeFileSync(files.program, JSON.stringify(program));
  const main = new URL("../../../apps/cli/src/main.ts", import.meta.url).pathname;
  const words = ["--maze", files.maze, "--program", files.program];
  const limits = ["--seconds", String(minutes * 60), "--until", until];
  const { stdout, stderr } = spawnSync(process.execPath, [main, "simulate", ...words, ...limits], {
    encoding: "utf8",
  });
  expect(stderr).toBe("");
  return JSON.parse(stdout) as {
    ticks: number;
    bumps: number;
    goal: { reached: boolean; tick: number | null };
  };
}

const aTrial = fc.record({
  mazes: fc.record({
    kind: fc.constantFrom(...mazeKinds),
    side: fc.constantFrom(5, 7, 9, 11, 13),
  }),
  seed: fc.nat(999_999_999),
  // Programs that are thought of get somewhere; the others are what nobody thought of.
  program: fc.oneof(
    fc.constantFrom(...programPresets.map(({ program }) => program)),
    arbitraryProgram,
  ),
});

describe("a program in another maze", () => {
  it("has the outcome that the command line's simulate gives", () => {
    fc.assert(
      fc.property(aTrial, ({ mazes, seed, program }) => {
        const maze = mazeOf(mazes, seed);
        const minutes = minutesFor(mazes.side);
        const { outcome, tick } = tryMaze(maze, program, minutes);
        const toGoal = simulate(maze, program, minutes, "goal");
        // A run to the goal, or to the time limit, without a bump leaves none to look for.
        const toBump = toGoal.bumps > 0 ? simulate(maze, program, minutes, "bump") : toGoal;
        const bumpsFirst = toBump.bumps > 0 && toBump.ticks <= (toGoal.goal.tick ?? Infinity);
        expect({ outcome, tick }).toEqual(
          bumpsFirst
            ? { outcome: "bump", tick: toBump.ticks }
            : toGoal.goal.reached
              ? { outcome: "works", tick: toGoal.goal.tick }
              : { outcome: "time-limit", tick: minutes * 3600 },
        );
      }),
      { numRuns: 20 },
    );
  }, 120_000);
});
