/** Walls that are connected neither with the outer wall nor, therefore, with a wall follower. */
import { isBlock, sizeOf } from "../maze-cells.ts";
import type { Cell, MazeDocument } from "../maze-document.ts";

/**
 * Finds the islands around the goals: blocks that touch a goal, also at a corner, and all blocks
 * connected with them. Single posts are no islands.
 * @returns the blocks of all islands; empty if the goals stand free, or touch the outer wall
 */
export function islandsAround(maze: MazeDocument): Cell[] {
  const { columns, rows } = sizeOf(maze);
  const seen = new Uint8Array(columns * rows);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const isEdge = row === 0 || column === 0 || row === rows - 1 || column === columns - 1;
      if (isEdge) connected(maze, { column, row }, seen);
    }
  }
  const islands: Cell[] = [];
  for (const goal of maze.goals) {
    for (const [right, down] of around) {
      const island = connected(maze, { column: goal.column + right, row: goal.row + down }, seen);
      if (island.length > 1) islands.push(...island);
    }
  }
  return islands;
}

const around = [-1, 0, 1].flatMap((down) => [-1, 0, 1].map((right) => [right, down] as const));

/** The blocks connected with a block, without those that were seen before. Marks them as seen. */
function connected(maze: MazeDocument, from: Cell, seen: Uint8Array): Cell[] {
  const { columns, rows } = sizeOf(maze);
  const found: Cell[] = [];
  const visit = ({ column, row }: Cell): void => {
    if (column < 0 || row < 0 || column >= columns || row >= rows) return;
    if (!isBlock(maze, column, row) || seen[row * columns + column] === 1) return;
    seen[row * columns + column] = 1;
    found.push({ column, row });
  };
  visit(from);
  // The list grows while it is read.
  for (const { column, row } of found) {
    visit({ column, row: row - 1 });
    visit({ column: column + 1, row });
    visit({ column, row: row + 1 });
    visit({ column: column - 1, row });
  }
  return found;
}
