/** Keys for a list in which things may repeat, such as two files of one name. */

/** @returns each with a key that no other has: what it is, and which one of these it is */
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
