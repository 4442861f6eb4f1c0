/** The end of the robot's trail, which a card leaves in sight: where the robot came from. Pure; units. */
import type { Pose } from "@corridor/protocol";

/** How much of the trail belongs to its end, from the robot's centre. */
const LENGTH = 100;
/** Half of the width that it is drawn with, and a little more. */
const HALF_WIDTH = 10;

interface Point {
  x: number;
  y: number;
}

/** -1: behind the robot; 1: ahead of one that drives in reverse */
export type TrailWay = -1 | 1;

/** The box around the end of the trail. */
export function trailEnd({ x, y, heading }: Pose, way: TrailWay) {
  const { dx, dy } = ahead(heading);
  const [endX, endY] = [x + way * LENGTH * dx, y + way * LENGTH * dy];
  return {
    x: Math.min(x, endX) - HALF_WIDTH,
    y: Math.min(y, endY) - HALF_WIDTH,
    width: Math.abs(endX - x) + 2 * HALF_WIDTH,
    height: Math.abs(endY - y) + 2 * HALF_WIDTH,
  };
}

/** Which end of the robot the trail leaves, when it touches a point: the one away from it. */
export function trailWay({ x, y, heading }: Pose, touched: Point): TrailWay {
  const { dx, dy } = ahead(heading);
  return (touched.x - x) * dx + (touched.y - y) * dy < 0 ? 1 : -1;
}

/** One unit along a heading. */
function ahead(heading: number): { dx: number; dy: number } {
  const angle = (heading * Math.PI) / 180;
  return { dx: Math.sin(angle), dy: -Math.cos(angle) };
}
