import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { countOpenCells, distancesFromStart, UNREACHABLE } from "./flood-fill.ts";
import { generateMaze, generateTree, mazeKinds, type MazeKind } from "./generate.ts";
import { isBlock, sizeOf } from "./maze-cells.ts";
import { parseMaze, type MazeDocument } from "./maze-document.ts";

const oddSide = fc.integer({ min: 2, max: 25 }).map((half) => 2 * half + 1);

/** Generates mazes of a kind. */
function anyMaze(kind: MazeKind): fc.Arbitrary<MazeDocument> {
  return fc
    .record({ columns: oddSide, rows: oddSide, seed: fc.integer() })
    .map((options) => generateMaze({ ...options, kind, name: "Generated" }));
}

/** Calls `visit` for every open cell. */
function eachOpen(maze: MazeDocument, visit: (column: number, row: number) => void): void {
  const { columns, rows } = sizeOf(maze);
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      if (!isBlock(maze, column, row)) visit(column, row);
    }
  }
}

/**
 * Number of adjacent pairs of open cells. A tree has one fewer than its open cells; loops add more.
 */
function countPassages(maze: MazeDocument): number {
  let count = 0;
  eachOpen(maze, (column, row) => {
    if (!isBlock(maze, column + 1, row)) count += 1;
    if (!isBlock(maze, column, row + 1)) count += 1;
  });
  return count;
}

/** Number of open squares with a given side, in cells. Squares may overlap. */
function countOpenSquares(maze: MazeDocument, side: number): number {
  const offsets = Array.from({ length: side * side }, (_, at) => at);
  let count = 0;
  eachOpen(maze, (column, row) => {
    const isOpen = offsets.every(
      (at) => !isBlock(maze, column + (at % side), row + Math.floor(at / side)),
    );
    if (isOpen) count += 1;
  });
  return count;
}

describe.each(mazeKinds)("a generated maze of kind %s", (kind) => {
  it("is a valid document with a solid border in which every open cell is reachable", () => {
    fc.assert(
      fc.property(anyMaze(kind), (maze) => {
        expect(parseMaze(maze)).toEqual({ ok: true, value: maze });
        const reached = distancesFromStart(maze).filter((distance) => distance !== UNREACHABLE);
        expect(reached).toHaveLength(countOpenCells(maze));
        const { columns, rows } = sizeOf(maze);
        eachOpen(maze, (column, row) => {
          expect(column % (columns - 1)).toBeGreaterThan(0);
          expect(row % (rows - 1)).toBeGreaterThan(0);
        });
      }),
    );
  });

  it("starts with a wall on the right and an open cell ahead; the goal is the farthest cell", () => {
    fc.assert(
      fc.property(anyMaze(kind), (maze) => {
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

  it("depends on the seed only", () => {
    const options = { kind, columns: 33, rows: 33, name: "Generated" };
    expect(generateMaze({ ...options, seed: 7 })).toEqual(generateMaze({ ...options, seed: 7 }));
    expect(generateMaze({ ...options, seed: 7 })).not.toEqual(
      generateMaze({ ...options, seed: 8 }),
    );
  });

  it.each([
    { columns: 4, rows: 5 },
    { columns: 5, rows: 3 },
    { columns: 257, rows: 5 },
    { columns: 5, rows: 7.5 },
    { columns: Number.NaN, rows: 5 },
  ])("rejects $columns x $rows with the field and the range", (size) => {
    expect(() => generateMaze({ ...size, kind, seed: 1, name: "" })).toThrow(
      /^(columns|rows): found .*, expected an odd number from 5 to 255$/,
    );
  });
});

describe("the kinds of generated mazes", () => {
  it("tree has exactly one path between any two cells, and all odd cells are open", () => {
    fc.assert(
      fc.property(anyMaze("tree"), (maze) => {
        expect(countPassages(maze)).toBe(countOpenCells(maze) - 1);
        const { columns, rows } = sizeOf(maze);
        for (let row = 1; row < rows; row += 2) {
          for (let column = 1; column < columns; column += 2) {
            expect(isBlock(maze, column, row)).toBe(false);
          }
        }
      }),
    );
  });

  it("loops contains cycles and no open square of 2 x 2 cells", () => {
    fc.assert(
      fc.property(anyMaze("loops"), (maze) => {
        expect(countPassages(maze)).toBeGreaterThanOrEqual(countOpenCells(maze));
        expect(countOpenSquares(maze, 2)).toBe(0);
      }),
    );
  });

  it("rooms contains a room of at least 3 x 3 cells", () => {
    fc.assert(
      fc.property(anyMaze("rooms"), (maze) => {
        expect(countOpenSquares(maze, 3)).toBeGreaterThanOrEqual(1);
      }),
    );
  });

  it("rooms divides areas longer than 9 cells", () => {
    const large = anyMaze("rooms").filter((maze) => Math.max(...Object.values(sizeOf(maze))) > 11);
    fc.assert(
      fc.property(large, (maze) => {
        const { columns, rows } = sizeOf(maze);
        // An undivided inside contains (columns - 4) * (rows - 4) such squares.
        expect(countOpenSquares(maze, 3)).toBeLessThan((columns - 4) * (rows - 4));
      }),
    );
  });

  it.each([
    {
      kind: "tree",
      blocks: [
        "###########",
        "#.#.......#",
        "#.#####.#.#",
        "#.#.....#.#",
        "#.#.#####.#",
        "#...#.....#",
        "###########",
      ],
    },
    {
      kind: "loops",
      blocks: [
        "###########",
        "#.#.......#",
        "#.#####.#.#",
        "#.#.....#.#",
        "#.#.#####.#",
        "#.........#",
        "###########",
      ],
    },
    {
      kind: "rooms",
      blocks: [
        "###########",
        "#.........#",
        "#.........#",
        "#.........#",
        "#.........#",
        "#.........#",
        "###########",
      ],
    },
  ] as const)("$kind generates the same maze as its first release", ({ kind, blocks }) => {
    const maze = generateMaze({ kind, columns: 11, rows: 7, seed: 42, name: "Generated" });
    expect(maze.blocks).toEqual(blocks);
  });

  it("generateTree returns the same maze as generateMaze with kind tree", () => {
    const options = { columns: 15, rows: 9, seed: 3, name: "Tree" };
    expect(generateTree(options)).toEqual(generateMaze({ ...options, kind: "tree" }));
  });
});
