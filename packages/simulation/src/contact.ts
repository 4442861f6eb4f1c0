/**
 * Where the robot touches what it has driven into: the flat side of a block, or only its corner. A
 * beam is a line and the robot is 50 cm wide, so the beam can pass a corner that the robot hits.
 */
import { CELL, isBlock, type Cell, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import { writeUnitVector } from "@corridor/geometry";

export interface Contact {
  /** the touched point, in units */
  x: number;
  y: number;
  /** the touched block; outside of the grid where the edge of the maze was touched */
  cell: Cell;
  /** whether the point is a corner of that block and no other block continues its side there */
  isCorner: boolean;
}

/** A robot that touches a flat side is straight before the touched point, up to so much, in units. */
const STRAIGHT = 1;

/**
 * The nearest point ahead of the robot that belongs to a block or to the edge of the maze.
 * @param pose of the robot at the bump
 * @param side the way that it drove
 */
export function contactOf(maze: MazeDocument, pose: Pose, side: "front" | "back"): Contact {
  const { x, y } = pose;
  const way = new Float64Array(2);
  writeUnitVector(pose.heading, way);
  const sign = side === "front" ? 1 : -1;
  const wayX = (way[0] ?? 0) * sign;
  const wayY = (way[1] ?? 0) * sign;
  const own = { column: Math.floor(x / CELL), row: Math.floor(y / CELL) };
  let best: Contact | null = null;
  let least = Infinity;
  for (let row = own.row - 1; row <= own.row + 1; row++) {
    for (let column = own.column - 1; column <= own.column + 1; column++) {
      if (!isBlock(maze, column, row)) continue;
      const pointX = Math.max(column * CELL, Math.min(x, (column + 1) * CELL));
      const pointY = Math.max(row * CELL, Math.min(y, (row + 1) * CELL));
      const dx = pointX - x;
      const dy = pointY - y;
      const distance = dx * dx + dy * dy;
      // What lies beside or behind the robot did not stop it.
      if (dx * wayX + dy * wayY <= 0 || distance >= least) continue;
      least = distance;
      best = {
        x: pointX,
        y: pointY,
        cell: { column, row },
        isCorner: isCorner(maze, pointX, pointY, dx, dy),
      };
    }
  }
  return best ?? { x, y, cell: own, isCorner: false };
}

/** Whether the point is where a wall ends, and no block beside it continues the side that was met. */
function isCorner(maze: MazeDocument, x: number, y: number, dx: number, dy: number): boolean {
  const isStraightX = Math.abs(dx) <= STRAIGHT;
  const isStraightY = Math.abs(dy) <= STRAIGHT;
  if (!isStraightX && !isStraightY) return true;
  // The two cells behind the point, seen from the robot, where it lies between two of them.
  const along = isStraightX ? x : y;
  const border = Math.round(along / CELL);
  if (Math.abs(along - border * CELL) > STRAIGHT) return false;
  const beyond = Math.floor((isStraightX ? y + Math.sign(dy) : x + Math.sign(dx)) / CELL);
  const isBlockAt = (at: number): boolean =>
    isStraightX ? isBlock(maze, at, beyond) : isBlock(maze, beyond, at);
  return !(isBlockAt(border - 1) && isBlockAt(border));
}
