import { programPresets, type ProgramDocument } from "@corridor/program";
import { openRun } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { mazeOf, minutesFor, tryMaze } from "./maze-trial.ts";
import { recordAttempt } from "./run-unit.ts";

describe("a program in another maze", () => {
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
        const written = recordAttempt({ maze, attempt: program, ticks: tick });
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
