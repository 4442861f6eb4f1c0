/** Formats the figures of a report. Digits are Latin in every language. */
import { localNumber } from "../../../text/numbers.ts";

/** Minutes and seconds, rounded to a second: "5:17". */
export function clockText(seconds: number): string {
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
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
