/** The square that a robot ran into: the one that its front or its back touches. */
import type { Cell } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";

const CELL = 100;
/** Just beyond the robot's edge, in units from its middle. */
const REACH = 27;

/** May lie outside of the maze, where the robot ran into its edge. */
export function hitBlock({ x, y, heading }: Pose, side: "front" | "back"): Cell {
  const radians = (heading * Math.PI) / 180;
  const reach = side === "front" ? REACH : -REACH;
  return {
    column: Math.floor((x + reach * Math.sin(radians)) / CELL),
    row: Math.floor((y - reach * Math.cos(radians)) / CELL),
  };
}
