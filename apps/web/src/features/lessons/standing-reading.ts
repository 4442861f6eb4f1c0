/** Reading of a robot that the hand has stopped, for missions that are driven by hand. */
import type { ChallengeDocument } from "@corridor/challenge";
import type { RunState } from "../../stores/run-store.ts";

/**
 * @returns reading of the sensor ahead, or of the sensor of the goal, in cm; null while the robot
 *   drives, before its first tick, and where it stands right, which the goal check reports
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
