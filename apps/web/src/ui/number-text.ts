/** Parses typed numbers: with a dot or a comma, with spaces around them. */

export interface NumberBounds {
  min: number;
  max: number;
  /** true if only integers are valid, such as for columns */
  whole?: boolean;
}

/** The parsed number, or null if the text is no number or out of bounds. */
export function readNumber(text: string, { min, max, whole = false }: NumberBounds): number | null {
  const trimmed = text.trim().replace(",", ".").replace("−", "-");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)$/.test(trimmed)) return null;
  const number = Number(trimmed);
  if (number < min || number > max || (whole && !Number.isInteger(number))) return null;
  return number === 0 ? 0 : number;
}
