import { generateTree, mazePresets, type MazeDocument } from "@corridor/maze";
import { arbitraryMaze } from "@corridor/maze/testing";
import { Simulation } from "@corridor/simulation";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { visibilityIn } from "./visibility.ts";

function mazeOf(...blocks: string[]): MazeDocument {
  const row = blocks.findIndex((text) => text.includes("S"));
  return {
    format: "corridor/maze",
    version: 1,
    name: "",
    blocks: blocks.map((text) => text.replace("S", ".")),
    start: { column: blocks[row]?.indexOf("S") ?? 0, row, heading: "east" },
    goals: [],
  };
}

/** Any driving by a student or a script. */
const drive = fc.oneof(
  fc.record({
    action: fc.constant("move" as const),
    distance: fc.integer({ min: -250, max: 400 }),
  }),
  fc.record({ action: fc.constant("turn" as const), degrees: fc.integer({ min: -180, max: 180 }) }),
  fc.constantFrom(
    { action: "left 90" as const },
    { action: "delayed right 90" as const },
    { action: "turn" as const, degrees: 45 },
    { action: "turn" as const, degrees: 26.57 },
  ),
);

describe("the bounds of readings", () => {
  it("include every reading, for any driving and heading", () => {
    fc.assert(
      fc.property(arbitraryMaze, fc.array(drive, { maxLength: 12 }), (maze, drives) => {
        const { range } = visibilityIn(maze);
        const simulation = new Simulation(maze);
        let [least, most] = [Infinity, -Infinity];
        for (const command of drives) {
          simulation.apply(command);
          do {
            simulation.step();
            least = Math.min(least, ...simulation.readings);
            most = Math.max(most, ...simulation.readings);
          } while (simulation.isManoeuvring);
        }
        expect(Math.min(least, range.min)).toBe(range.min);
        expect(Math.max(most, range.max)).toBe(range.max);
      }),
      { numRuns: 400 },
    );
  });

  it.each([
    ["a single cell", mazeOf("S"), Math.SQRT2],
    ["a corridor", mazeOf("#######", "#S....#", "#######"), Math.sqrt(26)],
    ["a room", mazeOf("S...", "....", "...."), 5],
    ["a corridor with a bend", mazeOf("S...", "###.", "###."), Math.sqrt(20)],
    ["cells that no way leads to do not count", mazeOf("S.#......"), Math.sqrt(5)],
    ["stairs, along which one can look", mazeOf("S.##", "#..#", "##.."), 5],
  ])("%s", (_, maze, cells) => {
    expect(visibilityIn(maze).range.max).toBeCloseTo(cells * 100 - 24.5, 6);
  });

  it.each(mazePresets)(
    "is at least the longest corridor of $id, and not twice as far",
    (preset) => {
      const { blocks } = preset.maze;
      const columns = Array.from(blocks[0] ?? "", (_, column) =>
        blocks.map((row) => row[column] ?? "").join(""),
      );
      const runs = [...blocks, ...columns].flatMap((text) => text.split("#"));
      const longest = Math.max(...runs.map((run) => run.length)) * 100;
      const { max } = visibilityIn(preset.maze).range;
      expect(max).toBeGreaterThan(longest - 25);
      expect(max).toBeLessThan(longest * 2);
    },
  );

  it("are the diagonal of the bounding box in the largest mazes", () => {
    const empty = mazeOf(
      "S" + ".".repeat(255),
      ...Array.from({ length: 255 }, () => ".".repeat(256)),
    );
    expect(visibilityIn(empty).range.max).toBeCloseTo(256 * 100 * Math.SQRT2 - 24.5, 6);
  });
});

describe("openings", () => {
  it.each([
    ["a straight corridor", mazeOf("S...."), false],
    ["a room without blocks", mazeOf("S..", "...", "..."), false],
    ["a bend", mazeOf("S.", "#."), true],
    ["a side corridor", mazeOf("S...", "#.##"), true],
    ["a bend that no way leads to", mazeOf("S.#.#", "###..", "#####"), false],
  ])("%s", (_, maze, expected) => {
    expect(visibilityIn(maze).hasOpenings).toBe(expected);
  });

  it("exist in every tree", () => {
    const tree = generateTree({ columns: 11, rows: 11, seed: 3, name: "" });
    expect(visibilityIn(tree).hasOpenings).toBe(true);
  });
});
