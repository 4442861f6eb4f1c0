/** Which readings matter now: those that the deciding line reads, and the side that touches a wall. */
import type { ProgramDocument } from "@corridor/program";
import type { SensorName, Snapshot } from "@corridor/protocol";

/** The sensors that the deciding line reads; none while no line decides. */
export function readSensors(
  program: ProgramDocument,
  snapshot: Snapshot | null,
): readonly SensorName[] {
  const line = snapshot?.line ?? null;
  if (line === null || line === "default") return [];
  const when = program.rules[line]?.when;
  if (when === undefined || when === null) return [];
  return when.than === "right" ? ["left", "right"] : [when.sensor];
}

/** The sensor on the side that is in contact: the robot only ever drives ahead or back. */
export function touchingSensor(snapshot: Snapshot | null): SensorName | null {
  if (snapshot === null || !snapshot.bumping) return null;
  return snapshot.motion === "reverse" ? "back" : "front";
}
