/**
 * Numbers of the run as the panels show them, with the decimal sign of the language. Figures are
 * Latin in every language: they are those of rulers, beams and program lines.
 */

/** Ticks in a second of simulated time. */
const TICKS_PER_SECOND = 60;

/** Languages that write a comma before the tenths; asking Intl costs the first screen 9 ms. */
const withComma: ReadonlySet<string> = new Set(["de", "es", "fr", "pt"]);

/** The sign before the tenths: "." or ",". */
export function decimalSign(language: string): string {
  return withComma.has(language) ? "," : ".";
}

/** A number written with a point, as the language writes it: "48.3" is "48,3" in German. */
export function localNumber(text: string, language: string): string {
  // A right-to-left script needs a mark that keeps the minus before its number.
  const minus = language === "ar" ? "\u200e-" : "-";
  return text.replace("-", minus).replace(".", decimalSign(language));
}

/** A reading in cm for the eye: at most one decimal, and none where it is 0. */
export function formatReading(centimetres: number, language = "en"): string {
  return localNumber(String(Number(centimetres.toFixed(1))), language);
}

/** Simulated time as minutes, seconds and tenths, cut and never rounded up: 1063 ticks are "0:17.7". */
export function formatClock(tick: number, language = "en"): string {
  const tenths = Math.floor((tick * 10) / TICKS_PER_SECOND);
  const minutes = Math.floor(tenths / 600);
  const seconds = (tenths % 600) / 10;
  return localNumber(`${minutes}:${seconds.toFixed(1).padStart(4, "0")}`, language);
}

/** Simulated time in seconds with one decimal, cut as the clock's: "39.2". */
export function formatSeconds(tick: number, language = "en"): string {
  return localNumber((Math.floor((tick * 10) / TICKS_PER_SECOND) / 10).toFixed(1), language);
}
