/** Draws a contest maze with posts and walls. */
import { isBlock } from "../maze-cells.ts";
import type { Cell } from "../maze-document.ts";
import { firstOpenHeading, GOAL_MARK, startMarks } from "../text-sketch.ts";
import { contestCellOf } from "./contest-cells.ts";
import type { ContestMaze } from "./contest-maze.ts";

const START_MARK = "S";

/** Trailing spaces are stripped, as editors do. The name and the order of goals are not drawn. */
export function writeDrawing({ columns, rows, maze }: ContestMaze): string {
  let text = "";
  for (let row = 0; row <= 2 * rows; row++) {
    let line = "";
    for (let column = 0; column <= 2 * columns; column++) {
      const isWall = isBlock(maze, column, row);
      if (contestCellOf({ columns, rows }, { column, row }) !== null) {
        line += ` ${markAt({ column, row })} `;
      } else if (row % 2 === 1) line += isWall ? "|" : " ";
      else if (column % 2 === 1) line += isWall ? "---" : "   ";
      else line += isWall ? "o" : " ";
    }
    text += `${line.trimEnd()}\n`;
  }
  return text;

  function markAt(cell: Cell): string {
    const isGoal = maze.goals.some((goal) => isSame(goal, cell));
    if (!isSame(maze.start, cell)) return isGoal ? GOAL_MARK : " ";
    const { heading } = maze.start;
    if (isGoal) return startMarks[heading].startAndGoal;
    const isPlain = heading === firstOpenHeading(maze.blocks, cell);
    return isPlain ? START_MARK : startMarks[heading].start;
  }
}

function isSame(a: Cell, b: Cell): boolean {
  return a.column === b.column && a.row === b.row;
}
