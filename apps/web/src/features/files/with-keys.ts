/** Keys for a list with repeated items, such as two files with one name. */

/**
 * @returns each value with a unique key: its name, and its number among the values with that name
 */
export function withKeys<Value>(
  values: readonly Value[],
  nameOf: (value: Value) => string,
): { key: string; value: Value }[] {
  const seen = new Map<string, number>();
  return values.map((value) => {
    const name = nameOf(value);
    const count = (seen.get(name) ?? 0) + 1;
    seen.set(name, count);
    return { key: `${count} ${name}`, value };
  });
}
