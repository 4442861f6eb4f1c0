/**
 * Parses typed numbers: with a dot or a comma, with spaces around them. Accepts the digits of every
 * keyboard for the languages of the page: Latin, Japanese and Chinese full-width, Arabic.
 */

export interface NumberBounds {
  min: number;
  max: number;
  /** true if only integers are valid, such as for columns */
  whole?: boolean;
}

/** The parsed number, or null if the text is no number or out of bounds. */
export function readNumber(text: string, { min, max, whole = false }: NumberBounds): number | null {
  const trimmed = withLatinDigits(text).trim().replace(/[,٫]/, ".").replace("−", "-");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)$/.test(trimmed)) return null;
  const number = Number(trimmed);
  if (number < min || number > max || (whole && !Number.isInteger(number))) return null;
  return number === 0 ? 0 : number;
}

/** Converts full-width characters and Arabic digits to Latin ones. */
function withLatinDigits(text: string): string {
  return text.normalize("NFKC").replaceAll(/[٠-٩]/g, (digit) => String(digit.charCodeAt(0) & 0xf));
}
