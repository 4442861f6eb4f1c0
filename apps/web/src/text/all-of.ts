import { groupedNumber } from "./grouped-number.ts";

/** Values for a text about all of `count` items: "both mazes" for 2, "all 1,001 mazes" for 1001. */
export function allOf(
  count: number,
  language: string,
): { count: number; all: string; context?: "both" } {
  const values = { count, all: groupedNumber(count, language) };
  return count === 2 ? { ...values, context: "both" } : values;
}
