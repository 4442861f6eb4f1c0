import fc from "fast-check";
import { expect, it } from "vitest";
import { KeyIndex } from "./key-index.ts";

it("stores the last value of each key of each driver, and counts them", () => {
  const change = fc.record({
    driver: fc.constantFrom("d", "e", "__proto__"),
    key: fc.constantFrom("", "k", "l"),
    value: fc.option(fc.nat()),
  });
  fc.assert(
    fc.property(fc.array(change), (changes) => {
      const index = new KeyIndex<number>();
      const plain = new Map<string, number>();
      for (const { driver, key, value } of changes) {
        const both = `${driver} ${key}`;
        if (value === null) {
          index.delete(driver, key);
          plain.delete(both);
        } else {
          index.set(driver, key, value);
          plain.set(both, value);
        }
        expect(index.get(driver, key)).toBe(plain.get(both));
        expect(index.size).toBe(plain.size);
      }
      for (const { driver, key } of changes)
        expect(index.get(driver, key)).toBe(plain.get(`${driver} ${key}`));
    }),
  );
});
