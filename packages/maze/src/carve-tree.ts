/**
 * Corridors one cell wide on the odd cells of a lattice, with exactly one way between any two open
 * cells, by depth-first search; and the same with some walls opened, so that there are ways round.
 */
import type { Cell } from "./maze-document.ts";
import { BLOCK, OPEN } from "./maze-limits.ts";
import type { Random } from "./random.ts";

/** Rows of single cells, while they are being dug. */
export type CellRows = string[][];

/** How many of a hundred walls that a tree leaves between its corridors a maze with loops opens. */
const OPENED_PERCENT = 15;

const steps = [
  { column: 0, row: -1 },
  { column: 1, row: 0 },
  { column: 0, row: 1 },
  { column: -1, row: 0 },
] as const;

/** All cells filled. */
export function solidRows(columns: number, rows: number): CellRows {
  return Array.from({ length: rows }, () => Array.from({ length: columns }, (): string => BLOCK));
}

/** Opens a cell; one outside of the rows is left alone. */
export function openCell(grid: CellRows, column: number, row: number): void {
  const cells = grid[row];
  if (cells !== undefined) cells[column] = OPEN;
}

/**
 * Walks from (1, 1) to unvisited cells two steps away, at random, and goes back where it is stuck.
 * @param columns odd, as `rows`
 */
export function carveTree(columns: number, rows: number, random: Random): CellRows {
  const grid = solidRows(columns, rows);
  const path: Cell[] = [{ column: 1, row: 1 }];
  openCell(grid, 1, 1);
  for (let here = path.at(-1); here !== undefined; here = path.at(-1)) {
    const { column, row } = here;
    const ways = steps.filter(
      (step) => grid[row + 2 * step.row]?.[column + 2 * step.column] === BLOCK,
    );
    const way = ways.length === 0 ? undefined : ways[random.below(ways.length)];
    if (way === undefined) {
      path.pop();
      continue;
    }
    const next = { column: column + 2 * way.column, row: row + 2 * way.row };
    openCell(grid, column + way.column, row + way.row);
    openCell(grid, next.column, next.row);
    path.push(next);
  }
  return grid;
}

/**
 * A tree with a share of its inner walls opened, at least one. The posts between four corridor cells
 * stay, so that no two by two cells are ever open.
 * @param columns odd and at least 5, as `rows`: smaller lattices have no wall whose loss makes a loop
 */
export function carveLoops(columns: number, rows: number, random: Random): CellRows {
  const grid = carveTree(columns, rows, random);
  const walls: Cell[] = [];
  for (let row = 1; row < rows - 1; row += 1) {
    // Between two corridor cells: in their row, or in their column.
    for (let column = 1 + (row % 2); column < columns - 1; column += 2) {
      if (grid[row]?.[column] === BLOCK) walls.push({ column, row });
    }
  }
  const count = Math.max(1, Math.floor((walls.length * OPENED_PERCENT) / 100));
  for (let opened = 0; opened < count; opened += 1) {
    // The chosen one changes places with the last, so that none is chosen twice.
    const at = random.below(walls.length);
    const last = walls.pop();
    const wall = at < walls.length ? walls[at] : last;
    if (last !== undefined && at < walls.length) walls[at] = last;
    if (wall !== undefined) openCell(grid, wall.column, wall.row);
  }
  return grid;
}
