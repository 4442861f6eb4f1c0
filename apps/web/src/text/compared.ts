/**
 * Rounded numbers that stand beside a comparison: short, but never so short that they would contradict it.
 * 250.46 > 60 is "250 > 60", but 50.4 > 50 is "50.4 > 50", because "50 > 50" reads as false. Numbers that are
 * nearer than any ruler shows are told apart by the last digit: 49.9999999 < 50 is "49.99 < 50".
 */
import type { Comparator, EvaluatedCondition } from "@corridor/program";

/** Digits after the point that the row of a line has room for. */
const MOST_DECIMALS = 2;

/** @param fewest digits after the point, of a number that has so many */
export function roundedSides(
  { left, is, right, isTrue }: EvaluatedCondition,
  fewest: number,
): { left: number; right: number } {
  for (let decimals = fewest; decimals <= MOST_DECIMALS; decimals++) {
    const shown = { left: round(left, decimals), right: round(right, decimals) };
    if (holds(shown.left, is, shown.right) === isTrue) return shown;
  }
  // Rounding keeps the order: only what is true, by less than a digit, comes here.
  const shownRight = round(right, MOST_DECIMALS);
  const apart = (is === ">" ? 1 : -1) / 10 ** MOST_DECIMALS;
  return { left: round(shownRight + apart, MOST_DECIMALS), right: shownRight };
}

function round(value: number, decimals: number): number {
  return Number(value.toFixed(decimals));
}

function holds(left: number, is: Comparator, right: number): boolean {
  return is === ">" ? left > right : left < right;
}
