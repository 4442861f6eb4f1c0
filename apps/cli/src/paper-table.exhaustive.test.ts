/**
 * Reproduces the table of the 2013 thesis: how each program behaves in tree mazes and corridors.
 */
import { generateTree } from "@corridor/maze";
import { paperPrograms } from "@corridor/program/testing";
import { CompiledProgram } from "@corridor/program";
import { ProgramRun, Simulation } from "@corridor/simulation";
import { describe, expect, it } from "vitest";
import { runProgram } from "./run-result.ts";

const sizes = [7, 11, 15, 21];
const seeds = [1, 2, 3, 4, 5, 6, 7, 8];
const trees = sizes.flatMap((size) =>
  seeds.map((seed) => ({
    name: `${size} x ${size}, seed ${seed}`,
    maze: generateTree({ columns: size, rows: size, seed, name: "tree" }),
  })),
);

/** The action of Figure 23 by the thesis; sides that differ by exactly 1 cm select the default. */
function farthestDistance(front: number, right: number, left: number): string {
  if (front > 50) return "forward";
  if (left > right + 1) return "left 90";
  return left < right + 1 ? "right 90" : "forward";
}

function figure(number: number) {
  const found = paperPrograms.find((each) => each.figure === number);
  if (found === undefined) throw new Error(`no program of Figure ${number}`);
  return found.program;
}

/** Enough time to drive every corridor of a tree in both directions, including turns. */
function secondsFor(openCells: number): number {
  return openCells * 4;
}

describe.each(trees)("in a tree maze of $name", ({ maze }) => {
  const openCells = maze.blocks.join("").split(".").length - 1;
  const limits = { seconds: secondsFor(openCells), until: "time" as const };

  it("Figure 22 visits every open cell without a bump", () => {
    const { bumps, visitedCells } = runProgram(maze, figure(22), limits);
    expect({ bumps, visitedCells }).toEqual({ bumps: 0, visitedCells: openCells });
  });

  it("Figure 23 drives forward if possible, else to the farther side, or right if both are equal", () => {
    const simulation = new Simulation(maze);
    const decider = new CompiledProgram(figure(23));
    const run = new ProgramRun(simulation, decider);
    const wrong: string[] = [];
    while (simulation.tick < limits.seconds * 60) {
      run.decide();
      const { front, right, left } = simulation.report().sensors;
      const expected = farthestDistance(front, right, left);
      const chosen = decider.commandOf(run.line === "default" ? -1 : run.line).action;
      if (chosen !== expected) wrong.push(`tick ${simulation.tick}: ${chosen}, not ${expected}`);
      do run.step();
      while (simulation.isManoeuvring);
    }
    expect(wrong).toEqual([]);
    expect(simulation.bumps).toBe(0);
  });

  it.each([24, 25, 26])("Figure %i bumps at least once", (number) => {
    const { bumps } = runProgram(maze, figure(number), { ...limits, until: "bump" });
    expect(bumps).toBeGreaterThanOrEqual(1);
  });
});

describe("Figure 19", () => {
  it.each([3, 8, 30])("drives back and forth in a straight corridor of %i cells", (cells) => {
    const maze = generateCorridor(cells);
    const { bumps, visitedCells, openCells, decisions } = runProgram(maze, figure(19), {
      seconds: cells * 6,
      until: "time",
    });
    expect({ bumps, visitedCells }).toEqual({ bumps: 0, visitedCells: openCells });
    expect(decisions.rules[0]).toBeGreaterThanOrEqual(2);
  });
});

function generateCorridor(cells: number) {
  const tree = generateTree({ columns: 5, rows: 5, seed: 1, name: "corridor" });
  const wall = "#".repeat(cells + 2);
  const start = { column: 1, row: 1, heading: "east" as const };
  return { ...tree, blocks: [wall, `#${".".repeat(cells)}#`, wall], start, goals: [] };
}
