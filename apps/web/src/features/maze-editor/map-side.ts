/**
 * The position of the small map: the lower left corner of the stage, unless the map would cover the
 * robot or a reading beside it. Pure; CSS pixels of the view.
 */

/** Distance from the robot's centre to the far end of a reading outside the wall beside it. */
const REACH_PX = 62;
/** Distance between the map and the edges of the stage. */
const EDGE_PX = 8;

interface Size {
  width: number;
  height: number;
}

/** Whether the map fits into the stage; in a low stage it would cover the tools above. */
export function hasMapRoom(view: Size, map: Size): boolean {
  return map.height + EDGE_PX <= view.height;
}

/** Left and right as in the maze, in every language. */
export function mapSide(robot: { x: number; y: number }, view: Size, map: Size): "left" | "right" {
  const isLow = robot.y + REACH_PX > view.height - EDGE_PX - map.height;
  const isNear = robot.x - REACH_PX < EDGE_PX + map.width;
  return isLow && isNear ? "right" : "left";
}
