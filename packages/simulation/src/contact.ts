/**
 * The point of contact between the robot and a block: on a flat side or at a corner. A sensor ray
 * is a line and the robot is 50 cm wide, so the ray can miss a corner that the robot hits.
 */
import { CELL, isBlock, type Cell, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import { writeUnitVector } from "@corridor/geometry";
import { ROBOT_RADIUS } from "./settings.ts";

export interface Contact {
  /** the touched point, in units */
  x: number;
  y: number;
  /** the touched block; outside the grid if the robot touched the edge of the maze */
  cell: Cell;
  /**
   * whether the point is a corner of that block where no adjacent block continues its side, and the
   * sensor ray in the driving direction passes beside the block
   */
  isCorner: boolean;
}

/**
 * Maximum sideways offset between the robot's centre and the contact point on a flat side, in
 * units.
 */
const STRAIGHT_TOLERANCE = 1;

/** A ray that is longer than the robot's radius by more than this measures no touched block. */
const RAY_TOLERANCE = 2;

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
  let rayToBest = Infinity;
  let ray = Infinity;
  for (let row = own.row - 1; row <= own.row + 1; row++) {
    for (let column = own.column - 1; column <= own.column + 1; column++) {
      if (!isBlock(maze, column, row)) continue;
      const rayToBlock = rayLength(column, row, x, y, directionX, directionY);
      ray = Math.min(ray, rayToBlock);
      const pointX = Math.max(column * CELL, Math.min(x, (column + 1) * CELL));
      const pointY = Math.max(row * CELL, Math.min(y, (row + 1) * CELL));
      const dx = pointX - x;
      const dy = pointY - y;
      const distance = dx * dx + dy * dy;
      // A block beside or behind the robot cannot stop it.
      if (dx * directionX + dy * directionY <= 0 || distance >= least) continue;
      least = distance;
      rayToBest = rayToBlock;
      best = {
        x: pointX,
        y: pointY,
        cell: { column, row },
        isCorner: isCorner(maze, pointX, pointY, dx, dy),
      };
    }
  }
  if (best === null) return { x, y, cell: own, isCorner: false };
  const isBesideRay = rayToBest === Infinity && ray > ROBOT_RADIUS + RAY_TOLERANCE;
  return { ...best, isCorner: best.isCorner && isBesideRay };
}

/** Length of the ray from (x, y) to a cell; infinite if the ray misses it. */
function rayLength(
  column: number,
  row: number,
  x: number,
  y: number,
  dx: number,
  dy: number,
): number {
  let near = 0;
  let far = Infinity;
  for (const [low, speed] of [
    [column * CELL - x, dx],
    [row * CELL - y, dy],
  ] as const) {
    if (speed === 0) {
      // A ray along a border belongs to the cell after it, as for the sensors.
      if (low > 0 || low + CELL <= 0) return Infinity;
      continue;
    }
    near = Math.max(near, Math.min(low / speed, (low + CELL) / speed));
    far = Math.min(far, Math.max(low / speed, (low + CELL) / speed));
  }
  return near <= far ? near : Infinity;
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
