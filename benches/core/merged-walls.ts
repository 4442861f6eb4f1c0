/**
 * Merges the blocks of a maze into few rectangles. Greedy: the longer run, horizontal or vertical.
 */
import { isBlock, sizeOf, type MazeDocument } from "@corridor/maze";

/** A rectangle of cells with its top left cell at (column, row), inside the grid or next to it. */
export interface Rectangle {
  column: number;
  row: number;
  columns: number;
  rows: number;
}

/** @returns rectangles that cover every block exactly once, and four for the border of the grid */
export function mergedWalls(maze: MazeDocument): Rectangle[] {
  const { columns, rows } = sizeOf(maze);
  const walls: Rectangle[] = [
    { column: 0, row: -1, columns, rows: 1 },
    { column: 0, row: rows, columns, rows: 1 },
    { column: -1, row: 0, columns: 1, rows },
    { column: columns, row: 0, columns: 1, rows },
  ];
  const isCovered = new Uint8Array(columns * rows);
  const isUncovered = (column: number, row: number): boolean =>
    column < columns &&
    row < rows &&
    isCovered[row * columns + column] === 0 &&
    isBlock(maze, column, row);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      if (!isUncovered(column, row)) continue;
      let across = 1;
      let down = 1;
      while (isUncovered(column + across, row)) across++;
      while (isUncovered(column, row + down)) down++;
      if (across >= down) down = 1;
      else across = 1;
      for (let r = 0; r < down; r++) {
        isCovered.fill(1, (row + r) * columns + column, (row + r) * columns + column + across);
      }
      walls.push({ column, row, columns: across, rows: down });
    }
  }
  return walls;
}
