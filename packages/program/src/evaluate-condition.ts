/**
 * Evaluates one condition with its numbers, such as "250 > 60", to display why a line was chosen or
 * not. The comparison is the same as in `CompiledProgram`, which runs programs.
 */
import type { SensorReadings } from "@corridor/protocol";
import type { Condition } from "./program-document.ts";
import type { Comparator } from "./vocabulary.ts";

/** A comparison with the values of both sides, in units. */
export interface EvaluatedCondition {
  isTrue: boolean;
  left: number;
  is: Comparator;
  /** the number of the line; for a comparison with right, the right reading plus that number */
  right: number;
}

/** @returns null for `[Do nothing]`, which is neither true nor false */
export function evaluateCondition(
  condition: Condition | null,
  readings: SensorReadings,
): EvaluatedCondition | null {
  if (condition === null) return null;
  const left = readings[condition.sensor];
  const right = condition.than === "right" ? readings.right + condition.plus : condition.than;
  const isTrue = condition.is === ">" ? left > right : left < right;
  return { isTrue, left, is: condition.is, right };
}
