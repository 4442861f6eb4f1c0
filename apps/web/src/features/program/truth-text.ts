/**
 * A comparison as text: short numbers, but never so short that they would contradict the truth.
 * 250.46 > 60 is "250.5 > 60"; 50.04 > 50 is "50.04 > 50", because "50 > 50" reads as false. Numbers that
 * are nearer than any ruler shows are told apart by the last digit: 49.9999999 < 50 is "49.99 < 50".
 */
import type { Comparator, Truth } from "@corridor/program";

/** Digits after the point that the row of a line has room for. */
const MOST_DECIMALS = 2;

/** @returns the sides in cm, the right one with its sign before it: "250.5" and "> 60" */
export function truthText({ left, is, right, isTrue }: Truth): { left: string; right: string } {
  for (let decimals = 1; decimals <= MOST_DECIMALS; decimals++) {
    const shownLeft = round(left, decimals);
    const shownRight = round(right, decimals);
    if (holds(shownLeft, is, shownRight) === isTrue) {
      return { left: String(shownLeft), right: `${is} ${shownRight}` };
    }
  }
  // Rounding keeps the order: only what is true, by less than a digit, comes here.
  const shownRight = round(right, MOST_DECIMALS);
  const apart = (is === ">" ? 1 : -1) / 10 ** MOST_DECIMALS;
  return { left: String(round(shownRight + apart, MOST_DECIMALS)), right: `${is} ${shownRight}` };
}

function round(value: number, decimals: number): number {
  return Number(value.toFixed(decimals));
}

function holds(left: number, is: Comparator, right: number): boolean {
  return is === ">" ? left > right : left < right;
}
