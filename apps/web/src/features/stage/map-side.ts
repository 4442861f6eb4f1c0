/**
 * Where the small map stands: in the lower left corner of the stage, unless the robot or a reading beside
 * it would stand under it there. Pure; CSS pixels of the view.
 */

/** From the robot's centre to the far end of a reading beyond the wall beside it. */
const REACH_PX = 62;
/** Between the map and the stage's edges. */
const EDGE_PX = 8;

interface Size {
  width: number;
  height: number;
}

/** Whether the map stays inside of the stage: a low one would have it over the tools above. */
export function hasMapRoom(view: Size, map: Size): boolean {
  return map.height + EDGE_PX <= view.height;
}

/** Left and right as in the maze, in every language. */
export function mapSide(robot: { x: number; y: number }, view: Size, map: Size): "left" | "right" {
  const isLow = robot.y + REACH_PX > view.height - EDGE_PX - map.height;
  const isNear = robot.x - REACH_PX < EDGE_PX + map.width;
  return isLow && isNear ? "right" : "left";
}
