import type { Task } from "@corridor/challenge";
import type { RunState } from "../../model/run/run-store.ts";

/** A stationary robot before its goal. A flat object, so that it can be compared cheaply. */
export interface StationaryRobot {
  x: number;
  y: number;
  heading: number;
  /** reading of the goal's sensor, in cm; null if the goal is a place */
  reading: number | null;
}

/**
 * The robot that was stopped by hand, for missions that are driven by hand.
 * @returns null while the robot drives, before its first tick, from a reset until the robot is
 *   displayed at its start, when the goal check reports success,
 *   and for a goal that is not met at a place
 */
export function stationaryRobot(
  { goal, allowed }: Pick<Task, "goal" | "allowed">,
  { snapshot, isCut, view }: Pick<RunState, "snapshot" | "isCut" | "view">,
): StationaryRobot | null {
  if (snapshot === null || isCut || view === "playing") return null;
  if (allowed.drivers[0] !== "me") return null;
  const { driver, tick, motion, goalReached, sensors, pose } = snapshot;
  if (driver !== "me" || tick === 0 || motion !== "stop" || goalReached) return null;
  if (goal.kind === "reach") return { ...pose, reading: null };
  if (goal.kind !== "stop") return null;
  const reading = sensors[goal.sensor];
  return reading >= goal.from && reading <= goal.to ? null : { ...pose, reading };
}
