/** Counts the lines with a condition. Lines without a condition do nothing. */
export function countLines(rules: readonly { when: unknown }[]): number {
  return rules.filter(({ when }) => when !== null).length;
}
