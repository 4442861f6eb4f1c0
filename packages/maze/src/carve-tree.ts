/**
 * Carves corridors one cell wide on the odd cells of a lattice by depth-first search, with exactly
 * one path between any two open cells. `carveLoops` opens some walls, which adds cycles.
 */
import type { Cell } from "./maze-document.ts";
import { BLOCK, OPEN } from "./maze-limits.ts";
import type { Random } from "./random.ts";

/** Mutable rows of single cells, used during generation. */
export type CellRows = string[][];

/** Percentage of the walls between corridors that `carveLoops` opens. */
const OPENED_PERCENT = 15;

const steps = [
  { column: 0, row: -1 },
  { column: 1, row: 0 },
  { column: 0, row: 1 },
  { column: -1, row: 0 },
] as const;

/** Creates rows in which all cells are blocks. */
export function solidRows(columns: number, rows: number): CellRows {
  return Array.from({ length: rows }, () => Array.from({ length: columns }, (): string => BLOCK));
}

/** Opens a cell. Ignores rows outside the grid. */
export function openCell(grid: CellRows, column: number, row: number): void {
  const cells = grid[row];
  if (cells !== undefined) cells[column] = OPEN;
}

/**
 * Random depth-first search from (1, 1) over lattice cells two steps apart, with backtracking.
 * @param columns odd, as `rows`
 */
export function carveTree(columns: number, rows: number, random: Random): CellRows {
  const grid = solidRows(columns, rows);
  const path: Cell[] = [{ column: 1, row: 1 }];
  openCell(grid, 1, 1);
  for (let current = path.at(-1); current !== undefined; current = path.at(-1)) {
    const { column, row } = current;
    const unvisited = steps.filter(
      (step) => grid[row + 2 * step.row]?.[column + 2 * step.column] === BLOCK,
    );
    const step = unvisited.length === 0 ? undefined : unvisited[random.below(unvisited.length)];
    if (step === undefined) {
      path.pop();
      continue;
    }
    const next = { column: column + 2 * step.column, row: row + 2 * step.row };
    openCell(grid, column + step.column, row + step.row);
    openCell(grid, next.column, next.row);
    path.push(next);
  }
  return grid;
}

/**
 * Carves a tree, then opens `OPENED_PERCENT` of its inner walls, at least one. The posts between
 * four corridor cells remain, so no open square of 2 x 2 cells exists.
 * @param columns odd and at least 5, as `rows`: in smaller lattices no opened wall creates a cycle
 */
export function carveLoops(columns: number, rows: number, random: Random): CellRows {
  const grid = carveTree(columns, rows, random);
  const walls: Cell[] = [];
  for (let row = 1; row < rows - 1; row += 1) {
    // Only cells between two corridor cells, horizontally or vertically.
    for (let column = 1 + (row % 2); column < columns - 1; column += 2) {
      if (grid[row]?.[column] === BLOCK) walls.push({ column, row });
    }
  }
  const count = Math.max(1, Math.floor((walls.length * OPENED_PERCENT) / 100));
  for (let opened = 0; opened < count; opened += 1) {
    // Replaces the chosen wall with the last one, so that no wall is chosen twice.
    const at = random.below(walls.length);
    const last = walls.pop();
    const wall = at < walls.length ? walls[at] : last;
    if (last !== undefined && at < walls.length) walls[at] = last;
    if (wall !== undefined) openCell(grid, wall.column, wall.row);
  }
  return grid;
}
