/** Moves the keyboard's cursor in the grid of squares. Pure. */
import type { Cell } from "@corridor/maze";

/** Rows by which Page Up and Page Down move. */
const PAGE = 10;

/** The part of KeyboardEvent that is used here. */
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

/** The cell, or the nearest cell inside a maze that has shrunk. */
export function clampCell({ column, row }: Cell, { columns, rows }: Size): Cell {
  const clamp = (value: number, count: number) => Math.min(count - 1, Math.max(0, value));
  return { column: clamp(column, columns), row: clamp(row, rows) };
}

/**
 * The cell to which a key moves; the same cell at an edge.
 * @returns null for keys that do not move the cursor
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

/** Whether a cell is the cursor's or next to it, so that it is in the DOM. */
export function isAround(cursor: Cell, { column, row }: Cell): boolean {
  return Math.abs(column - cursor.column) <= 1 && Math.abs(row - cursor.row) <= 1;
}

/**
 * Indices from `at - 1` to `at + 1` inside `0..count - 1`, which are in the DOM around the cursor.
 */
export function around(at: number, count: number): number[] {
  return [at - 1, at, at + 1].filter((index) => index >= 0 && index < count);
}
