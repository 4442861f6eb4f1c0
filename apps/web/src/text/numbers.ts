/**
 * Numbers of the run as the panels show them, with the decimal sign of the language. Figures are
 * Latin in every language: they are those of rulers, beams and program lines.
 */

/** Ticks in a second of simulated time. */
const TICKS_PER_SECOND = 60;

interface Signs {
  /** what stands before a negative number: right-to-left scripts need a mark that keeps it there */
  minus: string;
  decimal: string;
}

const known = new Map<string, Signs>();

function signsOf(language: string): Signs {
  let signs = known.get(language);
  if (signs === undefined) {
    const parts = new Intl.NumberFormat(language, { numberingSystem: "latn" }).formatToParts(-0.5);
    const figures = parts.findIndex(({ type }) => type === "integer");
    const before = parts.slice(0, figures).map(({ value }) => value);
    const decimal = parts.find(({ type }) => type === "decimal")?.value ?? ".";
    signs = { minus: before.join(""), decimal };
    known.set(language, signs);
  }
  return signs;
}

/** The sign before the tenths: "." or ",". */
export function decimalSign(language: string): string {
  return signsOf(language).decimal;
}

/** A number written with a point, as the language writes it: "48.3" is "48,3" in German. */
export function localNumber(text: string, language: string): string {
  const { minus, decimal } = signsOf(language);
  return text.replace("-", minus).replace(".", decimal);
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
