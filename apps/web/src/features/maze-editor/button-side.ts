/**
 * The position of the button over a stage that follows the robot: an upper corner, where it covers
 * neither a goal nor the robot. Pure; CSS pixels of the view.
 */
import type { Box } from "../../stage/drawing/viewport.ts";

export type Side = "left" | "right";

/** Width of the longest label with its icon, and height with the distance from the edge. */
const BUTTON = { width: 184, height: 56 };

/**
 * Left and right as in the maze, in every language.
 * @param avoided boxes that should stay visible
 * @param preferred the side where the button stands unless it covers less on the other
 */
export function buttonSide(
  avoided: readonly Box[],
  view: { width: number },
  preferred: Side,
): Side {
  const coveredOn = (side: Side): number => {
    const from = side === "left" ? 0 : view.width - BUTTON.width;
    return avoided.reduce((sum, box) => {
      const width = Math.min(from + BUTTON.width, box.x + box.width) - Math.max(from, box.x);
      const height = Math.min(BUTTON.height, box.y + box.height) - Math.max(0, box.y);
      return sum + Math.max(0, width) * Math.max(0, height);
    }, 0);
  };
  const other = preferred === "left" ? "right" : "left";
  return coveredOn(other) < coveredOn(preferred) ? other : preferred;
}
