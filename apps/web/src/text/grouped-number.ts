/** A whole number with separators: "1,000". Digits are Latin in every language. */
export function groupedNumber(number: number, language: string): string {
  return new Intl.NumberFormat(language, { numberingSystem: "latn" }).format(number);
}
