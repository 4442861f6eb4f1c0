/** Which sensors the running line of the program reads, so that their beams light up. */
import type { ProgramDocument } from "@corridor/program";
import type { SensorName, Snapshot } from "@corridor/protocol";

/** Empty when no line decides, or when the line reads nothing ("otherwise"). */
export function litSensors(
  program: ProgramDocument,
  snapshot: Pick<Snapshot, "driver" | "line">,
): readonly SensorName[] {
  if (snapshot.driver !== "program" || typeof snapshot.line !== "number") return [];
  const when = program.rules[snapshot.line]?.when ?? null;
  if (when === null) return [];
  return when.than === "right" ? [when.sensor, "right"] : [when.sensor];
}
