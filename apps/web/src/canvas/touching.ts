/** Which sensor looks at what the robot touches. A beam is thin and the robot is 50 cm wide: often none does. */
import type { SensorName, Snapshot } from "@corridor/protocol";

/** A sensor that reads more does not see what the robot touches: its radius and a little (units). */
export const TOUCHED_WITHIN = 25.5;

/**
 * The sensor that measures what the robot pushes against; null while it pushes against nothing, and where
 * all beams pass it: at a block's corner, or at a wall that it met at a slant.
 */
export function touchingSensor(
  snapshot: Pick<Snapshot, "bumping" | "pose" | "sensors"> | null,
): SensorName | null {
  if (snapshot === null || !snapshot.bumping) return null;
  const { pose, sensors } = snapshot;
  // A wall beside a robot that drives along it is not in its way.
  const isAlongWalls = pose.heading % 90 === 0;
  const sides: readonly SensorName[] = isAlongWalls
    ? ["front", "back"]
    : ["front", "back", "right", "left"];
  return sides.find((sensor) => sensors[sensor] <= TOUCHED_WITHIN) ?? null;
}
