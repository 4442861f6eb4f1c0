import { describe, expect, it } from "vitest";
import { countOpenCells, distancesFromStart, isReachable, UNREACHABLE } from "./flood-fill.ts";
import type { MazeDocument } from "./maze-document.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["..#.", "#.#.", "..##"],
  start: { column: 0, row: 0, heading: "east" },
  goals: [],
};

describe("flood fill", () => {
  it("counts steps from the start without crossing blocks, corners or edges", () => {
    const no = UNREACHABLE;
    expect([...distancesFromStart(maze)]).toEqual([0, 1, no, no, no, 2, no, no, 4, 3, no, no]);
  });

  it("includes unreachable cells in the number of open cells", () => {
    expect(countOpenCells(maze)).toBe(7);
  });

  it.each([
    [0, 2, true],
    [3, 0, false],
    [2, 0, false],
    [4, 0, false],
    [-1, 1, false],
    [0, 3, false],
  ])("returns whether (%i, %i) is reachable: %s", (column, row, expected) => {
    expect(isReachable(maze, { column, row })).toBe(expected);
  });
});
