/** A snapshot in words, for agents that read text only. */
import { type Snapshot, TICKS_PER_SECOND } from "@corridor/protocol";

/** Directions of the four headings, clockwise from 0 degrees. */
const directions = ["north", "east", "south", "west"] as const;

const round = (number: number): string => String(Math.round(number * 10) / 10);

/** Index of the nearest of the four directions: 0 north, 1 east, 2 south, 3 west. */
export function quarterOf(heading: number): number {
  return Math.round(heading / 90) % 4;
}

export function describeSnapshot(snapshot: Snapshot): string {
  const { sensors, pose, motion, bumps, bumping, goalReached, tick } = snapshot;
  const { front, right, back, left } = sensors;
  const quarter = quarterOf(pose.heading);
  const isExact = pose.heading === quarter * 90;
  const direction = `${isExact ? "" : "about "}${directions[quarter] ?? ""}`;
  return [
    `Free distance in cm: front ${round(front)}, right ${round(right)}, back ${round(back)}, left ${round(left)}.`,
    `Position: x ${round(pose.x)}, y ${round(pose.y)}, heading ${round(pose.heading)} (${direction}).`,
    `Motion: ${motion}. Bumps: ${bumps}${bumping ? ", touching a wall now" : ""}. Goal reached: ${goalReached ? "yes" : "no"}. Time: ${round(tick / TICKS_PER_SECOND)} s.`,
    ...hintsOf(snapshot),
  ].join("\n");
}

/** Why commands may not run now. */
function hintsOf({ state, driver }: Snapshot): string[] {
  const hints: string[] = [];
  if (state === "gone") {
    hints.push("The robot's page is closed: commands wait until its owner opens it again.");
  }
  if (state === "paused") hints.push("The robot is paused: commands wait until it continues.");
  if (driver !== "remote") {
    hints.push("Scripts do not drive now: its owner must choose Remote on the robot's page.");
  }
  return hints;
}
