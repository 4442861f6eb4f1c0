import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { countOpenCells, distancesFromStart, UNREACHABLE } from "./flood-fill.ts";
import { generateTree } from "./generate.ts";
import { isBlock, sizeOf } from "./maze-cells.ts";
import { parseMaze, type MazeDocument } from "./maze-document.ts";

const oddSide = fc.integer({ min: 2, max: 25 }).map((half) => 2 * half + 1);
const anyTree = fc
  .record({ columns: oddSide, rows: oddSide, seed: fc.integer() })
  .map((options) => generateTree({ ...options, name: "Tree" }));

/** Pairs of open cells side by side; a tree has one fewer than cells. */
function countPassages(maze: MazeDocument): number {
  const { columns, rows } = sizeOf(maze);
  let count = 0;
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      if (isBlock(maze, column, row)) continue;
      if (!isBlock(maze, column + 1, row)) count += 1;
      if (!isBlock(maze, column, row + 1)) count += 1;
    }
  }
  return count;
}

describe("a generated tree maze", () => {
  it("is a legal document with exactly one way between any two open cells", () => {
    fc.assert(
      fc.property(anyTree, (maze) => {
        expect(parseMaze(maze)).toEqual({ ok: true, value: maze });
        const reached = distancesFromStart(maze).filter((distance) => distance !== UNREACHABLE);
        expect(reached).toHaveLength(countOpenCells(maze));
        expect(countPassages(maze)).toBe(countOpenCells(maze) - 1);
      }),
    );
  });

  it("has a solid border and every odd cell open", () => {
    fc.assert(
      fc.property(anyTree, (maze) => {
        const { columns, rows } = sizeOf(maze);
        for (let row = 0; row < rows; row += 1) {
          for (let column = 0; column < columns; column += 1) {
            const isBorder =
              row === 0 || column === 0 || row === rows - 1 || column === columns - 1;
            const isNode = row % 2 === 1 && column % 2 === 1;
            const found = isBlock(maze, column, row);
            expect({ column, row, isFilled: isBorder || (found && !isNode) }).toEqual({
              column,
              row,
              isFilled: found,
            });
          }
        }
      }),
      { numRuns: 20 },
    );
  });

  it("starts with a wall on the right and open ahead, the goal at the farthest cell", () => {
    fc.assert(
      fc.property(anyTree, (maze) => {
        const { heading } = maze.start;
        expect(maze.start).toEqual({ column: 1, row: 1, heading });
        expect(["east", "south"]).toContain(heading);
        const [ahead, right] =
          heading === "east"
            ? [
                [2, 1],
                [1, 2],
              ]
            : [
                [1, 2],
                [0, 1],
              ];
        expect(isBlock(maze, ahead?.[0] ?? 0, ahead?.[1] ?? 0)).toBe(false);
        expect(isBlock(maze, right?.[0] ?? 0, right?.[1] ?? 0)).toBe(true);
        const distances = distancesFromStart(maze);
        const goal = maze.goals[0] ?? { column: 0, row: 0 };
        const { columns } = sizeOf(maze);
        expect(distances[goal.row * columns + goal.column]).toBe(Math.max(...distances));
      }),
    );
  });

  it("is the same for the same seed, and another for another", () => {
    const options = { columns: 33, rows: 33, name: "Tree" };
    expect(generateTree({ ...options, seed: 7 })).toEqual(generateTree({ ...options, seed: 7 }));
    expect(generateTree({ ...options, seed: 7 })).not.toEqual(
      generateTree({ ...options, seed: 8 }),
    );
  });

  it("stays what it was when it was first published", () => {
    expect(generateTree({ columns: 11, rows: 7, seed: 42, name: "Tree" }).blocks).toEqual([
      "###########",
      "#.#.......#",
      "#.#####.#.#",
      "#.#.....#.#",
      "#.#.#####.#",
      "#...#.....#",
      "###########",
    ]);
  });

  it.each([
    { columns: 4, rows: 5 },
    { columns: 5, rows: 3 },
    { columns: 257, rows: 5 },
    { columns: 5, rows: 7.5 },
    { columns: Number.NaN, rows: 5 },
  ])("refuses $columns x $rows with the field and the range", (size) => {
    expect(() => generateTree({ ...size, seed: 1, name: "" })).toThrow(
      /^(columns|rows): found .*, expected an odd number from 5 to 255$/,
    );
  });
});
