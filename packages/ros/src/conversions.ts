/**
 * Conversions to the conventions of ROS (REP 103 and 105): metres and radians, x forward, y left,
 * yaw counter-clockwise. The map's origin is the bottom left corner of the maze.
 */
import { normaliseHeading, writeUnitVector } from "@corridor/geometry";
import { type Pose, TICKS_PER_SECOND } from "@corridor/protocol";

const CM = 100;
/** m between the wheels */
export const TRACK_WIDTH = 0.4;
/** m/s of a wheel at full power */
export const WHEEL_SPEED = 2.61;

export interface RosPose {
  /** m */
  x: number;
  /** m */
  y: number;
  /** rad in (-pi, pi] */
  theta: number;
  /** of the yaw; x and y are 0 */
  orientation: Quaternion;
}

export interface Quaternion {
  x: number;
  y: number;
  z: number;
  w: number;
}

/** A time, by the field names of ROS 2 and of ROS 1, because clients read either. */
export interface Stamp {
  sec: number;
  nanosec: number;
  secs: number;
  nsecs: number;
}

export const metres = (cm: number): number => cm / CM;
export const centimetres = (m: number): number => m * CM;
export const radians = (degrees: number): number => (degrees * Math.PI) / 180;
export const degreesOf = (rad: number): number => (rad * 180) / Math.PI;

/** @param height of the maze in cm; 0 if the robot's maze is unknown */
export function rosPose({ x, y, heading }: Pose, height: number): RosPose {
  const yaw = yawOf(heading);
  return {
    x: metres(x),
    y: metres(height - y),
    theta: radians(yaw),
    orientation: quaternionOf(yaw),
  };
}

/** Degrees counter-clockwise from east, in (-180, 180]. */
function yawOf(heading: number): number {
  const yaw = normaliseHeading(90 - heading);
  return yaw > 180 ? yaw - 360 : yaw;
}

/** @param yaw degrees counter-clockwise */
export function quaternionOf(yaw: number): Quaternion {
  const [sin, cos] = sinCos(yaw / 2);
  return { x: 0, y: 0, z: sin, w: cos };
}

/** @param degrees counter-clockwise from east */
export function sinCos(degrees: number): readonly [sin: number, cos: number] {
  const vector = new Float64Array(2);
  writeUnitVector(normaliseHeading(degrees), vector);
  const [sin = 0, minusCos = 0] = vector;
  return [sin, -minusCos];
}

/** Simulated time. */
export function stampOf(tick: number): Stamp {
  const sec = Math.floor(tick / TICKS_PER_SECOND);
  const nanosec = Math.round(((tick % TICKS_PER_SECOND) * 1e9) / TICKS_PER_SECOND);
  return { sec, nanosec, secs: sec, nsecs: nanosec };
}

/** m/s and rad/s, in the frame of the robot. */
export interface Velocity {
  linear: number;
  angular: number;
}

/** The mean velocity between two poses. @param ticks between them, 1 or more */
export function velocityBetween(from: Pose, to: Pose, ticks: number): Velocity {
  const seconds = ticks / TICKS_PER_SECOND;
  const [sin, cos] = sinCos(90 - to.heading);
  const along = (to.x - from.x) * cos - (to.y - from.y) * sin;
  const turned = normaliseHeading(to.heading - from.heading);
  return {
    linear: metres(along) / seconds,
    angular: radians(turned > 180 ? 360 - turned : -turned) / seconds,
  };
}

/** Wheel powers for a velocity. Beyond full power, both are scaled down together. */
export function wheelPowers({ linear, angular }: Velocity): { left: number; right: number } {
  const turn = (angular * TRACK_WIDTH) / 2;
  const left = (linear - turn) / WHEEL_SPEED;
  const right = (linear + turn) / WHEEL_SPEED;
  const most = Math.max(1, Math.abs(left), Math.abs(right));
  // A number close to the largest one may overflow.
  if (!Number.isFinite(most))
    return wheelPowers({ linear: linear / 1e10, angular: angular / 1e10 });
  return { left: left / most, right: right / most };
}
