/** Draws a maze as text, one character a cell, with the robot. */
import { CELL, type Cell, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import { quarterOf } from "./snapshot-words.ts";

/** The cell in which the robot's centre is, and its heading in degrees. */
export interface RobotCell extends Cell {
  heading: number;
}

const robotMarks = ["^", ">", "v", "<"];

export const LEGEND =
  "# block, . open, S start, G goal; the robot: ^ > v < by the direction in which it looks.";

export function cellOf({ x, y, heading }: Pose): RobotCell {
  return { column: Math.floor(x / CELL), row: Math.floor(y / CELL), heading };
}

/** The robot's mark hides that of the start or of a goal. */
export function drawMaze({ blocks, start, goals }: MazeDocument, robot: RobotCell | null): string {
  const rows = blocks.map((row) => row.split(""));
  const put = ({ column, row }: Cell, mark: string): void => {
    const cells = rows[row];
    if (cells?.[column] !== undefined) cells[column] = mark;
  };
  put(start, "S");
  for (const goal of goals) put(goal, "G");
  if (robot !== null) put(robot, robotMarks[quarterOf(robot.heading)] ?? "^");
  return rows.map((row) => row.join("")).join("\n");
}
