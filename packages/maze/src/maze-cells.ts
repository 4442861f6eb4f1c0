/** Reads cells of a maze document. */
import type { MazeDocument } from "./maze-document.ts";
import { BLOCK } from "./maze-limits.ts";

/** Size of a maze in cells. */
export function sizeOf(maze: MazeDocument): { columns: number; rows: number } {
  return { columns: maze.blocks[0]?.length ?? 0, rows: maze.blocks.length };
}

/** Whether a cell is a block. Cells outside the grid count as blocks. */
export function isBlock(maze: MazeDocument, column: number, row: number): boolean {
  return (maze.blocks[row]?.[column] ?? BLOCK) === BLOCK;
}
