import fc from "fast-check";
import { expect, it } from "vitest";
import { withKeys } from "./with-keys.ts";

it("gives each item a unique key, in order and the same each time", () => {
  const anyNames = fc.array(fc.constantFrom("a.json", "b.json", "1 a.json", ""));
  fc.assert(
    fc.property(anyNames, (names) => {
      const keyed = withKeys(names, (name) => name);
      expect(new Set(keyed.map(({ key }) => key)).size).toBe(names.length);
      expect(keyed.map(({ value }) => value)).toEqual(names);
      expect(withKeys(names, (name) => name)).toEqual(keyed);
    }),
  );
});
