/**
 * Converts a maze to two SVG paths in cells: the blocks as areas, and the edge of their merged
 * shape.
 */
import { isBlock, sizeOf, type MazeDocument } from "@corridor/maze";

/** One rectangle for each run of blocks in a row, so that no seams show between neighbours. */
export function blocksPath(maze: MazeDocument): string {
  let path = "";
  for (const [y, row] of maze.blocks.entries()) {
    for (const run of row.matchAll(/#+/g)) {
      path += `M${run.index} ${y}h${run[0].length}v1h${-run[0].length}z`;
    }
  }
  return path;
}

/** Lines between blocks and open cells. Straight lines are joined. */
export function edgesPath(maze: MazeDocument): string {
  const { columns, rows } = sizeOf(maze);
  const isInside = (x: number, y: number) => x >= 0 && y >= 0 && x < columns && y < rows;
  const isEdge = (x1: number, y1: number, x2: number, y2: number): boolean =>
    isInside(x1, y1) && isInside(x2, y2) && isBlock(maze, x1, y1) !== isBlock(maze, x2, y2);
  let path = "";
  for (let y = 1; y < rows; y++) {
    path += runs(
      columns,
      (x) => isEdge(x, y - 1, x, y),
      (x, length) => `M${x} ${y}h${length}`,
    );
  }
  for (let x = 1; x < columns; x++) {
    path += runs(
      rows,
      (y) => isEdge(x - 1, y, x, y),
      (y, length) => `M${x} ${y}v${length}`,
    );
  }
  return path;
}

/** Writes each unbroken run of indexes below `count` for which `has` is true. */
function runs(
  count: number,
  has: (index: number) => boolean,
  write: (start: number, length: number) => string,
): string {
  let path = "";
  let length = 0;
  for (let index = 0; index <= count; index++) {
    if (index < count && has(index)) length++;
    else if (length > 0) {
      path += write(index - length, length);
      length = 0;
    }
  }
  return path;
}
