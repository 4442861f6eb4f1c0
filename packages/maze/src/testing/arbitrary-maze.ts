/** Random valid mazes for property tests: mostly small sides, any share of blocks, any name. */
import fc from "fast-check";
import { type MazeDocument } from "../maze-document.ts";
import { headingNames, MAX_GOALS, MAX_NAME_LENGTH } from "../maze-limits.ts";
import { createRandom } from "../random.ts";

const side = fc.oneof(
  { weight: 20, arbitrary: fc.integer({ min: 1, max: 12 }) },
  { weight: 4, arbitrary: fc.integer({ min: 13, max: 60 }) },
  { weight: 1, arbitrary: fc.integer({ min: 61, max: 256 }) },
);

/** Generates rows of blocks from a seed, which is faster than one fast-check value per cell. */
function rowsFrom(columns: number, rows: number, percent: number, seed: number): string[] {
  const random = createRandom(seed);
  return Array.from({ length: rows }, () =>
    Array.from({ length: columns }, () => (random.below(100) < percent ? "#" : ".")).join(""),
  );
}

/** Generates valid mazes. */
export const arbitraryMaze: fc.Arbitrary<MazeDocument> = fc
  .record({
    columns: side,
    rows: side,
    percent: fc.integer({ min: 0, max: 100 }),
    seed: fc.integer(),
    name: fc.string({ unit: "binary", maxLength: MAX_NAME_LENGTH / 2 }),
    start: fc.record({
      column: fc.nat(),
      row: fc.nat(),
      heading: fc.constantFrom(...headingNames),
    }),
    goals: fc.oneof(
      {
        weight: 9,
        arbitrary: fc.array(fc.record({ column: fc.nat(), row: fc.nat() }), { maxLength: 4 }),
      },
      {
        weight: 1,
        arbitrary: fc.array(fc.record({ column: fc.nat(), row: fc.nat() }), {
          minLength: MAX_GOALS,
          maxLength: MAX_GOALS,
        }),
      },
    ),
  })
  .map(({ columns, rows, percent, seed, name, start, goals }) => {
    const grid = rowsFrom(columns, rows, percent, seed).map((row) => row.split(""));
    const open = (column: number, row: number): void => {
      const cells = grid[row];
      if (cells !== undefined) cells[column] = ".";
    };
    const from = { ...start, column: start.column % columns, row: start.row % rows };
    const to = goals.map((goal) => ({ column: goal.column % columns, row: goal.row % rows }));
    for (const cell of [from, ...to]) open(cell.column, cell.row);
    const blocks = grid.map((row) => row.join(""));
    return { format: "corridor/maze", version: 1, name, blocks, start: from, goals: to };
  });
