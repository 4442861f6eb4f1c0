/** Where the keyboard goes in the grid of squares. Pure. */
import type { Cell } from "@corridor/maze";

/** Rows that Page Up and Page Down pass over. */
const PAGE = 10;

/** As much of a KeyboardEvent as is needed here. */
interface KeyFacts {
  key: string;
  ctrlKey: boolean;
  metaKey: boolean;
  altKey: boolean;
}

interface Size {
  columns: number;
  rows: number;
}

/** The cell itself, or the nearest one inside a maze that has become smaller. */
export function clampCell({ column, row }: Cell, { columns, rows }: Size): Cell {
  const clamp = (value: number, count: number) => Math.min(count - 1, Math.max(0, value));
  return { column: clamp(column, columns), row: clamp(row, rows) };
}

/**
 * The cell that a key leads to; the same one at an edge.
 * @returns null for keys that do not move
 */
export function moveCursor(cell: Cell, key: KeyFacts, size: Size): Cell | null {
  if (key.altKey) return null;
  const isFar = key.ctrlKey || key.metaKey;
  const to = (column: number, row: number): Cell => clampCell({ column, row }, size);
  switch (key.key) {
    case "Home":
      return to(0, isFar ? 0 : cell.row);
    case "End":
      return to(size.columns - 1, isFar ? size.rows - 1 : cell.row);
  }
  if (isFar) return null;
  switch (key.key) {
    case "ArrowUp":
      return to(cell.column, cell.row - 1);
    case "ArrowDown":
      return to(cell.column, cell.row + 1);
    case "ArrowLeft":
      return to(cell.column - 1, cell.row);
    case "ArrowRight":
      return to(cell.column + 1, cell.row);
    case "PageUp":
      return to(cell.column, cell.row - PAGE);
    case "PageDown":
      return to(cell.column, cell.row + PAGE);
    default:
      return null;
  }
}

/** Whether a cell is the cursor's or next to it, so that it exists in the page. */
export function isAround(cursor: Cell, { column, row }: Cell): boolean {
  return Math.abs(column - cursor.column) <= 1 && Math.abs(row - cursor.row) <= 1;
}

/** Indices from `at - 1` to `at + 1` inside `0..count - 1`: what exists in the page around the cursor. */
export function around(at: number, count: number): number[] {
  return [at - 1, at, at + 1].filter((index) => index >= 0 && index < count);
}
