/**
 * The part of the program that the beams show: the sensors that the running line reads, and the
 * limits.
 */
import type { ProgramDocument } from "@corridor/program";
import type { SensorName, Snapshot } from "@corridor/protocol";

/** The number of a line, on the beam of the sensor that the line reads. */
export interface Limit {
  /** index of the line from 0 */
  line: number;
  sensor: SensorName;
  /** units from the robot's centre */
  distance: number;
  isRunning: boolean;
}

/** More marks than this would be unreadable. The running line's mark is always included. */
const MAX_LIMITS = 6;

/**
 * Sensors that the running line reads. Empty without a running line, or if it reads nothing
 * ("otherwise").
 */
export function litSensors(
  program: ProgramDocument,
  snapshot: Pick<Snapshot, "driver" | "line">,
): readonly SensorName[] {
  if (snapshot.driver !== "program" || typeof snapshot.line !== "number") return [];
  const when = program.rules[snapshot.line]?.when ?? null;
  if (when === null) return [];
  return when.than === "right" ? [when.sensor, "right"] : [when.sensor];
}

/**
 * The numbers that lines compare their sensors with, the running line first. Empty unless the
 * program drives.
 */
export function limitsOf(
  program: ProgramDocument,
  snapshot: Pick<Snapshot, "driver" | "line">,
): Limit[] {
  if (snapshot.driver !== "program") return [];
  const limits = program.rules.flatMap(({ when }, line): Limit[] => {
    if (when === null || when.than === "right" || when.than === 0) return [];
    const isRunning = line === snapshot.line;
    return [{ line, sensor: when.sensor, distance: when.than, isRunning }];
  });
  return limits.sort((a, b) => Number(b.isRunning) - Number(a.isRunning)).slice(0, MAX_LIMITS);
}
