/** The goals of the core, each a number that one run measures and a bound for it. */

export interface Goal {
  words: string;
  measured: number;
  /** the largest number that still passes, or the smallest */
  bound: { atMost: number } | { atLeast: number };
  unit: string;
}

/** A number that could not be measured (NaN) passes nothing. */
export function isMet({ measured, bound }: Goal): boolean {
  return "atMost" in bound ? measured <= bound.atMost : measured >= bound.atLeast;
}

export function goalLine(goal: Goal): string {
  const { words, measured, bound, unit } = goal;
  const limit = "atMost" in bound ? `at most ${bound.atMost}` : `at least ${bound.atLeast}`;
  return `${isMet(goal) ? "PASS" : "FAIL"}  ${words}: ${digits(measured)} ${unit} (${limit})`;
}

/** Three digits are all that a shared machine can tell; thousands grouped. */
export function digits(number: number): string {
  return number.toLocaleString("en", { maximumSignificantDigits: 3 });
}
