import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { mazeKinds } from "@corridor/maze";
import { programPresets, type ProgramDocument } from "@corridor/program";
import { arbitraryProgram } from "@corridor/program/testing";
import { openRun } from "@corridor/recording";
import fc from "fast-check";
import { afterAll, describe, expect, it } from "vitest";
import { mazeOf, minutesFor, recordTrial, tryMaze } from "./maze-trial.ts";

const folder = mkdtempSync(join(tmpdir(), "corridor-trial-"));
afterAll(() => rmSync(folder, { recursive: true }));

/** Output of the command line for the same maze and program. */
function simulate(maze: unknown, program: unknown, minutes: number, until: "goal" | "bump") {
  const files = { maze: join(folder, "maze.json"), program: join(folder, "program.json") };
  writeFileSync(files.maze, JSON.stringify(maze));
  writeFileSync(files.program, JSON.stringify(program));
  const main = new URL("../../../../cli/src/main.ts", import.meta.url).pathname;
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
        const toBump = simulate(maze, program, minutes, "bump");
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

  it("works with the right-wall program in every tree", () => {
    const { program } = named("right-wall");
    for (let seed = 1; seed <= 100; seed++) {
      const maze = mazeOf({ kind: "tree", side: 11 }, seed);
      expect(tryMaze(maze, program, minutesFor(11)).outcome).toBe("works");
    }
  });

  it("ends with the time where the robot gets nowhere without a bump", () => {
    const { program } = named("back-and-forth");
    const circles: ProgramDocument = { ...program, default: "turn 180", rules: [] };
    const maze = mazeOf({ kind: "tree", side: 5 }, 1);
    expect(tryMaze(maze, circles, 1)).toEqual({ outcome: "time-limit", tick: 3600 });
  });

  it("is recorded as a run that opens at the tick of its failure", () => {
    const { program } = named("left-at-every-wall");
    fc.assert(
      fc.property(fc.nat(9_999), (seed) => {
        const maze = mazeOf({ kind: "tree", side: 9 }, seed, "Tree");
        const { outcome, tick } = tryMaze(maze, program, 1);
        const written = recordTrial(maze, program, tick);
        if (!written.ok) throw new Error(written.reason);
        const opened = openRun(written.run);
        if (!opened.ok) throw new Error("the run does not open");
        expect(opened.value.run.tick).toBe(tick);
        expect(opened.value.run.bumps).toBe(outcome === "bump" ? 1 : 0);
      }),
      { numRuns: 30 },
    );
  });
});

function named(id: string): (typeof programPresets)[number] {
  const found = programPresets.find((preset) => preset.id === id);
  if (found === undefined) throw new Error(`there is no ${id}`);
  return found;
}
