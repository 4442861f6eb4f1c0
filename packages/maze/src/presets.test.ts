import { describe, expect, it } from "vitest";
import { isReachable } from "./flood-fill.ts";
import { generateTree } from "./generate.ts";
import { isBlock } from "./maze-cells.ts";
import { parseMaze } from "./maze-document.ts";
import { type HeadingName } from "./maze-limits.ts";
import { mazePresets } from "./presets.ts";

/** Steps to the cell ahead and to the cell on the right, by heading. */
const steps: Record<HeadingName, { ahead: [number, number]; right: [number, number] }> = {
  north: { ahead: [0, -1], right: [1, 0] },
  east: { ahead: [1, 0], right: [0, 1] },
  south: { ahead: [0, 1], right: [-1, 0] },
  west: { ahead: [-1, 0], right: [0, -1] },
};

describe("maze presets", () => {
  it("have unique ids and names", () => {
    const ids = mazePresets.map(({ id }) => id);
    expect(new Set(ids).size).toBe(ids.length);
    expect(new Set(mazePresets.map(({ maze }) => maze.name)).size).toBe(ids.length);
  });

  it.each(mazePresets)(
    "$id is valid, solvable, and starts with a wall on the right",
    ({ maze }) => {
      expect(parseMaze(maze)).toEqual({ ok: true, value: maze });
      expect(maze.goals.every((goal) => isReachable(maze, goal))).toBe(true);
      const { column, row, heading } = maze.start;
      const { ahead, right } = steps[heading];
      expect(isBlock(maze, column + ahead[0], row + ahead[1])).toBe(false);
      expect(isBlock(maze, column + right[0], row + right[1])).toBe(true);
    },
  );

  it("tree equals the generator's output", () => {
    const tree = mazePresets.find(({ id }) => id === "tree")?.maze;
    expect(tree).toEqual(generateTree({ columns: 15, rows: 15, seed: 1, name: "Tree" }));
  });
});
