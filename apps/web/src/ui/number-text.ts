/** What people type as a number: with a dot or a comma, with spaces around it. */

export interface NumberBounds {
  min: number;
  max: number;
  /** true where only whole numbers make sense, such as columns */
  whole?: boolean;
}

/** The number that a text stands for, or null when it is none or out of bounds. */
export function readNumber(text: string, { min, max, whole = false }: NumberBounds): number | null {
  const trimmed = text.trim().replace(",", ".").replace("−", "-");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)$/.test(trimmed)) return null;
  const number = Number(trimmed);
  if (number < min || number > max || (whole && !Number.isInteger(number))) return null;
  return number === 0 ? 0 : number;
}
