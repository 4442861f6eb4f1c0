/**
 * Formats the numbers of a run with the decimal separator of the language. Digits are Latin in every
 * language, as on rulers, beams and program lines.
 */
import { TICKS_PER_SECOND } from "@corridor/protocol";

/** Languages with a decimal comma. Intl would delay the first screen by 9 ms. */
const withComma: ReadonlySet<string> = new Set(["de", "es", "fr", "pt"]);

/** The decimal separator: "." or ",". */
export function decimalSign(language: string): string {
  return withComma.has(language) ? "," : ".";
}

/** Converts a number with a decimal point to the language: "48.3" is "48,3" in German. */
export function localNumber(text: string, language: string): string {
  // In right-to-left text, a left-to-right mark keeps the minus before its number.
  const minus = language === "ar" ? "\u200e-" : "-";
  return text.replace("-", minus).replace(".", decimalSign(language));
}

/** A reading in cm with one decimal, omitted if it is 0. */
export function formatReading(centimetres: number, language = "en"): string {
  return localNumber(String(Number(centimetres.toFixed(1))), language);
}

/** Simulated time in minutes, seconds and tenths, rounded down: 1063 ticks are "0:17.7". */
export function formatClock(tick: number, language = "en"): string {
  const tenths = Math.floor((tick * 10) / TICKS_PER_SECOND);
  const minutes = Math.floor(tenths / 600);
  const seconds = (tenths % 600) / 10;
  return localNumber(`${minutes}:${seconds.toFixed(1).padStart(4, "0")}`, language);
}

/** Simulated time in seconds as the page displays it: rounded down to a tenth. */
export function displayedSeconds(tick: number): number {
  return Math.floor((tick * 10) / TICKS_PER_SECOND) / 10;
}

/** Simulated time in seconds with one decimal, rounded down: "39.2". */
export function formatSeconds(tick: number, language = "en"): string {
  return localNumber(displayedSeconds(tick).toFixed(1), language);
}
