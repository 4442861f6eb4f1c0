/**
 * The point of contact between the robot and a block: on a flat side or at a corner. A sensor ray
 * is a line and the robot is 50 cm wide, so the ray can miss a corner that the robot hits.
 */
import { CELL, isBlock, type Cell, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import { writeUnitVector } from "@corridor/geometry";

export interface Contact {
  /** the touched point, in units */
  x: number;
  y: number;
  /** the touched block; outside the grid if the robot touched the edge of the maze */
  cell: Cell;
  /** whether the point is a corner of that block where no adjacent block continues its side */
  isCorner: boolean;
}

/**
 * Maximum sideways offset between the robot's centre and the contact point on a flat side, in
 * units.
 */
const STRAIGHT_TOLERANCE = 1;

/**
 * Returns the nearest point of a block or of the maze's edge in the driving direction.
 * @param pose pose of the robot at the bump
 * @param side side of the robot in the driving direction
 */
export function contactOf(maze: MazeDocument, pose: Pose, side: "front" | "back"): Contact {
  const { x, y } = pose;
  const direction = new Float64Array(2);
  writeUnitVector(pose.heading, direction);
  const sign = side === "front" ? 1 : -1;
  const directionX = (direction[0] ?? 0) * sign;
  const directionY = (direction[1] ?? 0) * sign;
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
      // A block beside or behind the robot cannot stop it.
      if (dx * directionX + dy * directionY <= 0 || distance >= least) continue;
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

/**
 * Whether the wall ends at the point, without an adjacent block that continues the touched side.
 */
function isCorner(maze: MazeDocument, x: number, y: number, dx: number, dy: number): boolean {
  const isStraightX = Math.abs(dx) <= STRAIGHT_TOLERANCE;
  const isStraightY = Math.abs(dy) <= STRAIGHT_TOLERANCE;
  if (!isStraightX && !isStraightY) return true;
  // If the point is between two cells, both cells beyond it (seen from the robot) must be blocks.
  const along = isStraightX ? x : y;
  const border = Math.round(along / CELL);
  if (Math.abs(along - border * CELL) > STRAIGHT_TOLERANCE) return false;
  const beyond = Math.floor((isStraightX ? y + Math.sign(dy) : x + Math.sign(dx)) / CELL);
  const isBlockAt = (at: number): boolean =>
    isStraightX ? isBlock(maze, at, beyond) : isBlock(maze, beyond, at);
  return !(isBlockAt(border - 1) && isBlockAt(border));
}
