/** Breadth-first search from the start over adjacent open cells. */
import { sizeOf } from "./maze-cells.ts";
import { type Cell, type MazeDocument } from "./maze-document.ts";
import { OPEN } from "./maze-limits.ts";

/** Distance of a block, or of an open cell that has no path from the start. */
export const UNREACHABLE = -1;

/** Number of open cells, reachable or not. */
export function countOpenCells(maze: MazeDocument): number {
  let count = 0;
  for (const row of maze.blocks) {
    for (const mark of row) if (mark === OPEN) count += 1;
  }
  return count;
}

/**
 * Computes the number of steps from the start to every cell.
 * @returns one number per cell, at index `row * columns + column`: 0 at the start, `UNREACHABLE`
 *   where no path exists
 */
export function distancesFromStart(maze: MazeDocument): Int32Array {
  const { columns, rows } = sizeOf(maze);
  const distances = new Int32Array(columns * rows).fill(UNREACHABLE);
  const queue = new Int32Array(columns * rows);
  let end = 0;
  const visit = (column: number, row: number, distance: number): void => {
    const at = row * columns + column;
    if (maze.blocks[row]?.[column] !== OPEN || distances[at] !== UNREACHABLE) return;
    distances[at] = distance;
    queue[end] = at;
    end += 1;
  };
  visit(maze.start.column, maze.start.row, 0);
  for (let head = 0; head < end; head += 1) {
    const at = queue[head] ?? 0;
    const column = at % columns;
    const row = (at - column) / columns;
    const distance = (distances[at] ?? 0) + 1;
    visit(column, row - 1, distance);
    visit(column + 1, row, distance);
    visit(column, row + 1, distance);
    visit(column - 1, row, distance);
  }
  return distances;
}

/** Whether a path of open cells leads from the start to a cell. */
export function isReachable(maze: MazeDocument, { column, row }: Cell): boolean {
  const { columns } = sizeOf(maze);
  if (column < 0 || column >= columns) return false;
  return (distancesFromStart(maze)[row * columns + column] ?? UNREACHABLE) !== UNREACHABLE;
}
