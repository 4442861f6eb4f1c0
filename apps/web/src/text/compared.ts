/**
 * Rounds the two numbers of a comparison as far as possible without contradicting it. 250.46 > 60
 * becomes "250 > 60", but 50.4 > 50 stays "50.4 > 50", because "50 > 50" reads as false. Numbers that
 * differ by less than the last digit get different digits: 49.9999999 < 50 becomes "49.99 < 50".
 */
import {
  evaluateCondition,
  type Comparator,
  type Condition,
  type EvaluatedCondition,
} from "@corridor/program";
import type { SensorReadings } from "@corridor/protocol";

/** Largest number of decimals that fits into the row of a line. */
const MOST_DECIMALS = 2;

/** @param fewest smallest number of decimals, for a number that has them */
export function roundedSides(
  { left, is, right, isTrue }: EvaluatedCondition,
  fewest: number,
): { left: number; right: number } {
  for (let decimals = fewest; decimals <= MOST_DECIMALS; decimals++) {
    const shown = { left: round(left, decimals), right: round(right, decimals) };
    if (holds(shown.left, is, shown.right) === isTrue) return shown;
  }
  // Rounding preserves the order, so only a true comparison by less than one digit gets here.
  const shownRight = round(right, MOST_DECIMALS);
  const apart = (is === ">" ? 1 : -1) / 10 ** MOST_DECIMALS;
  return { left: round(shownRight + apart, MOST_DECIMALS), right: shownRight };
}

/**
 * The readings of one tick, in whole cm. A reading has decimals if the whole number would
 * contradict one of the conditions.
 * @param conditions all comparisons that are displayed with these readings
 */
export function roundedReadings(
  readings: SensorReadings,
  conditions: readonly (Condition | null)[],
): SensorReadings {
  const shown = {
    front: Math.round(readings.front),
    right: Math.round(readings.right),
    back: Math.round(readings.back),
    left: Math.round(readings.left),
  };
  for (const condition of conditions) {
    const truth = evaluateCondition(condition, readings);
    if (condition === null || truth === null) continue;
    if (evaluateCondition(condition, shown)?.isTrue === truth.isTrue) continue;
    const sides = roundedSides(truth, 1);
    shown[condition.sensor] = sides.left;
    if (condition.than === "right") shown.right = sides.right - condition.plus;
  }
  return shown;
}

function round(value: number, decimals: number): number {
  return Number(value.toFixed(decimals));
}

function holds(left: number, is: Comparator, right: number): boolean {
  return is === ">" ? left > right : left < right;
}
