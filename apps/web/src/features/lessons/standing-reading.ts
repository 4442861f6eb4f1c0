import type { ChallengeDocument } from "@corridor/challenge";
import type { RunState } from "../../stores/run-store.ts";

/**
 * The reading of a robot that was stopped by hand, for missions that are driven by hand.
 * @returns reading in cm of the goal's sensor, or else of the front sensor. null while the robot
 *   drives, before its first tick, and when the goal check reports success.
 */
export function standingReading(
  { goal, allowed }: Pick<ChallengeDocument, "goal" | "allowed">,
  { snapshot, view }: Pick<RunState, "snapshot" | "view">,
): number | null {
  if (snapshot === null || view === "playing" || allowed.drivers[0] !== "me") return null;
  const { driver, tick, motion, goalReached, sensors } = snapshot;
  if (driver !== "me" || tick === 0 || motion !== "stop" || goalReached) return null;
  if (goal.kind !== "stop") return sensors.front;
  const reading = sensors[goal.sensor];
  return reading >= goal.from && reading <= goal.to ? null : reading;
}
