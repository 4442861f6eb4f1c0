/**
 * A whole number, 0 or more, with separators: "1,000". Digits are Latin in every language. Numbers
 * without a separator need no Intl, which would delay the first screen.
 */
export function groupedNumber(number: number, language: string): string {
  if (number < 1_000) return String(number);
  return new Intl.NumberFormat(language, { numberingSystem: "latn" }).format(number);
}
