/** The blocks of a maze as few rectangles: each takes the longer run of blocks, across or down. */
import { isBlock, sizeOf, type MazeDocument } from "@corridor/maze";

/** Cells from (column, row) on; inside or just outside of the grid. */
export interface Rectangle {
  column: number;
  row: number;
  columns: number;
  rows: number;
}

/** Every block lies in exactly one rectangle; four more stand around the grid. */
export function mergedWalls(maze: MazeDocument): Rectangle[] {
  const { columns, rows } = sizeOf(maze);
  const walls: Rectangle[] = [
    { column: 0, row: -1, columns, rows: 1 },
    { column: 0, row: rows, columns, rows: 1 },
    { column: -1, row: 0, columns: 1, rows },
    { column: columns, row: 0, columns: 1, rows },
  ];
  const isTaken = new Uint8Array(columns * rows);
  const isFree = (column: number, row: number): boolean =>
    column < columns &&
    row < rows &&
    isTaken[row * columns + column] === 0 &&
    isBlock(maze, column, row);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      if (!isFree(column, row)) continue;
      let across = 1;
      let down = 1;
      while (isFree(column + across, row)) across++;
      while (isFree(column, row + down)) down++;
      if (across >= down) down = 1;
      else across = 1;
      for (let r = 0; r < down; r++) {
        isTaken.fill(1, (row + r) * columns + column, (row + r) * columns + column + across);
      }
      walls.push({ column, row, columns: across, rows: down });
    }
  }
  return walls;
}
