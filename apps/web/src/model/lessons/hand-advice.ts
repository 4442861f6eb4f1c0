/**
 * What helps a robot that was stopped by hand before its goal: to drive on, to drive back, or to
 * turn first. Decided by the free path along its heading, not by the distance alone.
 */
import type { Goal } from "@corridor/challenge";
import { CELL, gridOf, isBlock, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import { readingsAt, ROBOT_RADIUS } from "@corridor/simulation";
import { pointAhead } from "../../stage/layers/path-ahead.ts";

/** `turn`: no straight drive helps from here; `far`: not even after a turn */
export type HandAdvice = "ahead" | "behind" | "turn" | "far";

/** Units between two places that are tried. */
const STEP = 1;
/** Overlap with a block, in units, that counts as a touch. */
const TOUCH = 0.5;
/** Tolerance for rounding errors where the robot drives along a wall, in units. */
const EPSILON = 1e-6;
/** Degrees between two headings that are tried. */
const TURN = 5;

/**
 * @param maze has the goals of a goal that is a place
 * @param pose of a robot that has not met its goal
 */
export function handAdvice(goal: Goal, maze: MazeDocument, pose: Pose): HandAdvice {
  const isMetAt = goalCheck(goal, maze);
  const ahead = distanceTo(isMetAt, maze, pose, STEP);
  const behind = distanceTo(isMetAt, maze, pose, -STEP);
  if (ahead !== Infinity || behind !== Infinity) return ahead <= behind ? "ahead" : "behind";
  for (let degrees = TURN; degrees < 360; degrees += TURN) {
    const heading = (Math.round(pose.heading / TURN) * TURN + degrees) % 360;
    if (distanceTo(isMetAt, maze, { ...pose, heading }, STEP) !== Infinity) return "turn";
  }
  return "far";
}

/** Returns the check of whether a robot that stands still at a pose meets the goal. */
function goalCheck(goal: Goal, maze: MazeDocument): (pose: Pose) => boolean {
  if (goal.kind === "stop") {
    const grid = gridOf(maze);
    const { sensor, from, to } = goal;
    return (pose) => {
      const reading = readingsAt(grid, pose)[sensor];
      return reading >= from && reading <= to;
    };
  }
  return ({ x, y }) =>
    maze.goals.some(({ column, row }) => isInside(x, column) && isInside(y, row));
}

/** Whether the whole robot is between the borders of the cell. */
function isInside(coordinate: number, cell: number): boolean {
  return Math.abs(coordinate - (cell + 0.5) * CELL) <= CELL / 2 - ROBOT_RADIUS + EPSILON;
}

/**
 * Distance to drive straight until the goal is met; infinite if a block is in the way.
 * @param step negative to drive backward
 */
function distanceTo(
  isMetAt: (pose: Pose) => boolean,
  maze: MazeDocument,
  from: Pose,
  step: number,
): number {
  const { heading } = from;
  for (let driven = step; ; driven += step) {
    const pose = { ...pointAhead(from, heading, driven), heading };
    if (!hasRoom(maze, pose, from)) return Infinity;
    if (isMetAt(pose)) return Math.abs(driven);
  }
}

/** Whether a robot that drove straight to the pose is not stopped by a block there. */
function hasRoom(maze: MazeDocument, { x, y }: Pose, from: Pose): boolean {
  const own = { column: Math.floor(x / CELL), row: Math.floor(y / CELL) };
  for (let row = own.row - 1; row <= own.row + 1; row++) {
    for (let column = own.column - 1; column <= own.column + 1; column++) {
      if (!isBlock(maze, column, row)) continue;
      const dx = Math.max(column * CELL, Math.min(x, (column + 1) * CELL)) - x;
      const dy = Math.max(row * CELL, Math.min(y, (row + 1) * CELL)) - y;
      const isTouched = Math.hypot(dx, dy) < ROBOT_RADIUS - TOUCH;
      // A robot that stands at a wall can leave it.
      if (isTouched && dx * (x - from.x) + dy * (y - from.y) > 0) return false;
    }
  }
  return !isBlock(maze, own.column, own.row);
}
