/** The robot's position in words: its square and the direction that it faces. Pure. */
import type { Pose } from "@corridor/protocol";
import { CELL, type Cell } from "@corridor/maze";

const facings = [
  "up",
  "upRight",
  "right",
  "downRight",
  "down",
  "downLeft",
  "left",
  "upLeft",
] as const;

/** One of eight directions, as displayed on the stage. */
export type Facing = (typeof facings)[number];

/** The nearest of eight directions. @param heading degrees clockwise from north */
export function facingOf(heading: number): Facing {
  return facings[Math.round(heading / 45) % 8] ?? "up";
}

/** The square under the robot's centre. */
export function cellOf(pose: Pose): Cell {
  return { column: Math.floor(pose.x / CELL), row: Math.floor(pose.y / CELL) };
}
