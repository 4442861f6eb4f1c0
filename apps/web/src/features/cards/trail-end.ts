/** The end of the robot's trail, where the robot came from; cards leave it visible. Pure; units. */
import type { Pose } from "@corridor/protocol";

/** Length of the end of the trail, from the robot's centre. */
const LENGTH = 100;
/** Half of the drawn width, plus a margin. */
const HALF_WIDTH = 10;

interface Point {
  x: number;
  y: number;
}

/** -1: behind the robot; 1: ahead of the robot, which drives in reverse */
export type TrailSide = -1 | 1;

/** Bounding box of the end of the trail. */
export function trailEnd({ x, y, heading }: Pose, side: TrailSide) {
  const { dx, dy } = ahead(heading);
  const [endX, endY] = [x + side * LENGTH * dx, y + side * LENGTH * dy];
  return {
    x: Math.min(x, endX) - HALF_WIDTH,
    y: Math.min(y, endY) - HALF_WIDTH,
    width: Math.abs(endX - x) + 2 * HALF_WIDTH,
    height: Math.abs(endY - y) + 2 * HALF_WIDTH,
  };
}

/**
 * Returns the side on which the trail leaves a robot that touches a point: the side away from it.
 */
export function trailSide({ x, y, heading }: Pose, touched: Point): TrailSide {
  const { dx, dy } = ahead(heading);
  return (touched.x - x) * dx + (touched.y - y) * dy < 0 ? 1 : -1;
}

/** Unit vector along a heading. */
function ahead(heading: number): { dx: number; dy: number } {
  const angle = (heading * Math.PI) / 180;
  return { dx: Math.sin(angle), dy: -Math.cos(angle) };
}
