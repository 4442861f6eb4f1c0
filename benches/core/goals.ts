/** Performance goals: a measured number and its bound. */

export interface Goal {
  label: string;
  measured: number;
  /** the largest or smallest number that passes */
  bound: { atMost: number } | { atLeast: number };
  unit: string;
}

/** Whether the goal is met. NaN, for a number that could not be measured, never meets a goal. */
export function isMet({ measured, bound }: Goal): boolean {
  return "atMost" in bound ? measured <= bound.atMost : measured >= bound.atLeast;
}

/** Formats a goal as one line that starts with PASS or FAIL. */
export function formatGoal(goal: Goal): string {
  const { label, measured, bound, unit } = goal;
  const limit = "atMost" in bound ? `at most ${bound.atMost}` : `at least ${bound.atLeast}`;
  return `${isMet(goal) ? "PASS" : "FAIL"}  ${label}: ${formatNumber(measured)} ${unit} (${limit})`;
}

/**
 * Formats a number with 3 significant digits, the precision of a shared machine, and separators.
 */
export function formatNumber(number: number): string {
  return number.toLocaleString("en", { maximumSignificantDigits: 3 });
}
