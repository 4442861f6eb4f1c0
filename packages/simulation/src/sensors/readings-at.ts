/** The four sensor readings at any pose, for questions about places where the robot is not. */
import { writeUnitVector } from "@corridor/geometry";
import type { Grid } from "@corridor/maze";
import type { Pose, SensorReadings } from "@corridor/protocol";
import { writeRange } from "./range-sensor.ts";

/** @param pose its position is inside an open cell */
export function readingsAt(grid: Grid, { x, y, heading }: Pose): SensorReadings {
  const direction = new Float64Array(2);
  writeUnitVector(heading, direction);
  const [dx = 0, dy = 0] = direction;
  const out = new Float64Array(4);
  writeRange(grid, x, y, dx, dy, out, 0);
  writeRange(grid, x, y, -dy, dx, out, 1);
  writeRange(grid, x, y, -dx, -dy, out, 2);
  writeRange(grid, x, y, dy, -dx, out, 3);
  const [front = 0, right = 0, back = 0, left = 0] = out;
  return { front, right, back, left };
}
