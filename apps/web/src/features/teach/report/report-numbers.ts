/** Formats the figures of a report. Digits are Latin in every language. */
import { clockText } from "../../../text/clock-text.ts";
import { localNumber } from "../../../text/numbers.ts";

/** A time, rounded to a second: "5:17". */
export function timeText(seconds: number): string {
  return clockText(Math.round(seconds));
}

/** @param digits after the decimal sign */
export function decimalText(value: number, language: string, digits: number): string {
  return localNumber(value.toFixed(digits), language);
}

/** One digit after the decimal sign, or none if it is zero. */
export function shortNumber(value: number, language: string): string {
  return localNumber(String(Number(value.toFixed(1))), language);
}

/** A share as a percentage: "3.6 %". @param digits at most, after the decimal sign */
export function percentText(share: number, language: string): string {
  return new Intl.NumberFormat(language, {
    style: "percent",
    numberingSystem: "latn",
    maximumFractionDigits: 1,
  }).format(share);
}

/** The name of a task or question by its column: "right_wall" is "right wall". */
export function columnName(id: string): string {
  return id.replaceAll("_", " ");
}
