import { clockText } from "../../text/clock-text.ts";

/** A time of the class: "14:02", or "1:04:02" after an hour. @param ms rounded down to seconds */
export function classTimeText(ms: number): string {
  return clockText(Math.max(0, Math.floor(ms / 1_000)));
}
