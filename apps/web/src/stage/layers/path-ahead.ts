/**
 * Where a running manoeuvre takes the robot, computed from its pose and the rest of the manoeuvre.
 */
import type { Pose } from "@corridor/protocol";
import { ROBOT_RADIUS, LEAVE_DISTANCE, type Progress } from "@corridor/simulation";

interface Point {
  x: number;
  y: number;
}

/**
 * The point at a distance in units from another one.
 * @param heading degrees clockwise from north
 */
export function pointAhead({ x, y }: Point, heading: number, distance: number): Point {
  const radians = (heading * Math.PI) / 180;
  return { x: x + Math.sin(radians) * distance, y: y - Math.cos(radians) * distance };
}

/**
 * The rest of the path of a delayed turn: from the robot's centre to the turning point, and out of
 * the junction to the end position of its front.
 * @returns three points, or two once the robot has turned; null for every other action
 */
export function delayedPath(pose: Pose, progress: Progress | null): Point[] | null {
  if (progress === null || !progress.action.startsWith("delayed")) return null;
  const { kind, part, left, direction } = progress;
  const from = { x: pose.x, y: pose.y };
  const leaving = LEAVE_DISTANCE + ROBOT_RADIUS;
  if (kind === "turn") return [from, pointAhead(from, pose.heading + direction * left, leaving)];
  if (part > 0) return [from, pointAhead(from, pose.heading, left + ROBOT_RADIUS)];
  const corner = pointAhead(from, pose.heading, left);
  const quarter = progress.action === "delayed right 90" ? 90 : -90;
  return [from, corner, pointAhead(corner, pose.heading + quarter, leaving)];
}

/**
 * The pose at which a drive or a turn on the spot ends without an obstacle; null for every other
 * action.
 */
export function endOf(pose: Pose, progress: Progress | null): Pose | null {
  if (progress === null || progress.parts > 1) return null;
  const { kind, left, direction } = progress;
  if (kind === "turn") return { ...pose, heading: pose.heading + direction * left };
  if (kind === "drive") {
    return { ...pointAhead(pose, pose.heading, direction * left), heading: pose.heading };
  }
  return null;
}
