import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { MazeDocument } from "./maze-document.ts";
import { isSameLayout, isSameMaze } from "./same-maze.ts";
import { arbitraryMaze } from "./testing/arbitrary-maze.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "A",
  blocks: ["..", ".#"],
  start: { column: 0, row: 0, heading: "north" },
  goals: [{ column: 1, row: 0 }],
};

describe("equal mazes", () => {
  it("are equal after they were copied", () => {
    fc.assert(
      fc.property(arbitraryMaze, (each) => {
        expect(isSameMaze(each, structuredClone(each))).toBe(true);
      }),
    );
  });

  it("have the same layout under another name", () => {
    const renamed = { ...maze, name: "B" };
    expect(isSameLayout(maze, renamed)).toBe(true);
    expect(isSameMaze(maze, renamed)).toBe(false);
  });

  it.each<{ name: string; change: Partial<MazeDocument> }>([
    { name: "a block", change: { blocks: ["..", ".."] } },
    { name: "a row", change: { blocks: ["..", ".#", ".."] } },
    { name: "the start", change: { start: { column: 0, row: 1, heading: "north" } } },
    { name: "the heading", change: { start: { column: 0, row: 0, heading: "east" } } },
    { name: "a goal", change: { goals: [{ column: 0, row: 1 }] } },
    { name: "the number of goals", change: { goals: [] } },
  ])("differ in $name", ({ change }) => {
    expect(isSameLayout(maze, { ...maze, ...change })).toBe(false);
    expect(isSameLayout({ ...maze, ...change }, maze)).toBe(false);
  });
});
