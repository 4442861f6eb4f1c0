/** Looking at the cells of a maze document. */
import type { MazeDocument } from "./maze-document.ts";
import { BLOCK } from "./maze-limits.ts";

/** `{columns, rows}` of a maze, in cells. */
export function sizeOf(maze: MazeDocument): { columns: number; rows: number } {
  return { columns: maze.blocks[0]?.length ?? 0, rows: maze.blocks.length };
}

/** Whether a cell holds a block; outside the grid is solid. */
export function isBlock(maze: MazeDocument, column: number, row: number): boolean {
  return (maze.blocks[row]?.[column] ?? BLOCK) === BLOCK;
}
