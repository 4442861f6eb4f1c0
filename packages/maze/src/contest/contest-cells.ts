/**
 * The cells of a contest maze. Its walls have no width, so n x m contest cells are (2n + 1) x
 * (2m + 1) cells of a maze document: cell (x, y) counts from the bottom left, and is cell
 * (2x + 1, 2(m - 1 - y) + 1) of the document. The wall between two contest cells is the cell between
 * them, and the rest are posts.
 */
import type { Cell, Start } from "../maze-document.ts";
import { MAX_SIDE } from "../maze-limits.ts";

/** Maximum number of contest cells on a side. */
export const MAX_CONTEST_SIDE = Math.floor((MAX_SIDE - 1) / 2);

/** Size of a contest maze in contest cells. */
export interface ContestSize {
  columns: number;
  rows: number;
}

/** A contest cell: `x` to the right and `y` up, from 0 at the bottom left. */
export interface ContestCell {
  x: number;
  y: number;
}

/** The cell of the document. */
export function cellOf({ rows }: ContestSize, { x, y }: ContestCell): Cell {
  return { column: 2 * x + 1, row: 2 * (rows - 1 - y) + 1 };
}

/** The contest cell at a cell of the document; null on a wall or a post. */
export function contestCellOf({ rows }: ContestSize, { column, row }: Cell): ContestCell | null {
  if (column % 2 === 0 || row % 2 === 0) return null;
  return { x: (column - 1) / 2, y: rows - 1 - (row - 1) / 2 };
}

/** The start of a contest: bottom left, facing north. */
export function contestStart(size: ContestSize): Start {
  return { ...cellOf(size, { x: 0, y: 0 }), heading: "north" };
}

/**
 * The goals of a contest: the centre, which has one, two or four cells. In reading order, as a
 * drawing has them.
 */
export function contestGoals(size: ContestSize): Cell[] {
  const goals: Cell[] = [];
  for (const y of middle(size.rows).toReversed()) {
    for (const x of middle(size.columns)) goals.push(cellOf(size, { x, y }));
  }
  return goals;
}

/** The middle of a side: one index if its length is odd, otherwise two. */
function middle(length: number): number[] {
  return length % 2 === 1 ? [(length - 1) / 2] : [length / 2 - 1, length / 2];
}
