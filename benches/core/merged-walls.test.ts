import { generateTree, isBlock, mazePresets, sizeOf } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { mergedWalls } from "./merged-walls.ts";

const mazes = [
  ...mazePresets.map(({ id, maze }) => ({ name: id, maze })),
  ...[1, 2, 3].map((seed) => ({
    name: `a tree of seed ${seed}`,
    maze: generateTree({ columns: 33, rows: 21, seed, name: "tree" }),
  })),
];

describe("merged walls", () => {
  it.each(mazes)("cover every block of $name once, no open cell, and the border", ({ maze }) => {
    const { columns, rows } = sizeOf(maze);
    const covered = new Map<string, number>();
    for (const wall of mergedWalls(maze)) {
      for (let row = wall.row; row < wall.row + wall.rows; row++) {
        for (let column = wall.column; column < wall.column + wall.columns; column++) {
          const cell = `${column} ${row}`;
          covered.set(cell, (covered.get(cell) ?? 0) + 1);
        }
      }
    }
    for (let row = -1; row <= rows; row++) {
      for (let column = -1; column <= columns; column++) {
        const isInX = column >= 0 && column < columns;
        const isInY = row >= 0 && row < rows;
        // The four outer corners touch no cell of the maze.
        const isWall = isInX && isInY ? isBlock(maze, column, row) : isInX || isInY;
        expect(covered.get(`${column} ${row}`) ?? 0).toBe(isWall ? 1 : 0);
      }
    }
  });
});
