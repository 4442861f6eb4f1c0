import type { ProgramDocument } from "@corridor/program";
import type { SensorName, Snapshot } from "@corridor/protocol";

/** The sensors that the deciding line reads; empty if no line decides. */
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
