/**
 * Which sensor measures the contact at a bump. A beam is thin and the robot is 50 units wide, so
 * often none does.
 */
import type { SensorName, Snapshot } from "@corridor/protocol";

/**
 * Largest reading, in units, of a sensor that measures the contact: the robot's radius plus a
 * tolerance.
 */
export const CONTACT_RANGE = 25.5;

/**
 * The sensor that measures what the robot pushes against. Null while the robot pushes against
 * nothing, and where all beams miss the contact: at the corner of a block, or at a wall that the
 * robot meets at an angle.
 */
export function contactSensor(
  snapshot: Pick<Snapshot, "bumping" | "pose" | "sensors"> | null,
): SensorName | null {
  if (snapshot === null || !snapshot.bumping) return null;
  const { pose, sensors } = snapshot;
  // A robot that drives along a wall does not push against it.
  const isAlongWalls = pose.heading % 90 === 0;
  const sides: readonly SensorName[] = isAlongWalls
    ? ["front", "back"]
    : ["front", "back", "right", "left"];
  return sides.find((sensor) => sensors[sensor] <= CONTACT_RANGE) ?? null;
}
