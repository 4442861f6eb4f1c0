/**
 * Why a line did or did not fire: one condition with the numbers put in, such as "250 > 60".
 * The comparison is the one that the program runs with; for display only, one line at a time.
 */
import type { SensorReadings } from "@corridor/protocol";
import type { Condition } from "./program-document.ts";
import type { Comparator } from "./vocabulary.ts";

/** A comparison with both sides known, in units. */
export interface Truth {
  isTrue: boolean;
  left: number;
  is: Comparator;
  /** the number of the line; for left against right, the right reading plus that number */
  right: number;
}

/** @returns null for `[Do nothing]`, which is neither true nor false */
export function truthOf(condition: Condition | null, readings: SensorReadings): Truth | null {
  if (condition === null) return null;
  const left = readings[condition.sensor];
  const right = condition.than === "right" ? readings.right + condition.plus : condition.than;
  const isTrue = condition.is === ">" ? left > right : left < right;
  return { isTrue, left, is: condition.is, right };
}
