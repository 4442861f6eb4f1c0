/** The outer wall and the posts of a contest maze. Only drawings can have gaps in them. */
import { isBlock, sizeOf } from "../maze-cells.ts";
import type { MazeDocument } from "../maze-document.ts";

/** Whether all cells on the edge are blocks. */
export function hasOuterWall(maze: MazeDocument): boolean {
  const isWhole = (row = ""): boolean => /^#*$/.test(row);
  return (
    isWhole(maze.blocks[0]) &&
    isWhole(maze.blocks.at(-1)) &&
    maze.blocks.every((row) => row.startsWith("#") && row.endsWith("#"))
  );
}

/** Number of missing posts. */
export function missingPosts(maze: MazeDocument): number {
  const { columns, rows } = sizeOf(maze);
  let count = 0;
  for (let row = 0; row < rows; row += 2) {
    for (let column = 0; column < columns; column += 2) {
      if (!isBlock(maze, column, row)) count += 1;
    }
  }
  return count;
}
