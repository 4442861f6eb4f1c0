import fc from "fast-check";
import { expect, it } from "vitest";
import { EntryOwners } from "./entry-owners.ts";

const owner = fc.constantFrom("a", "b", "c");
const change = fc.oneof(
  { weight: 3, arbitrary: fc.record({ add: owner, gap: fc.nat(3) }) },
  fc.record({ deleteUpTo: fc.nat(9) }),
  fc.record({ deleteOf: fc.array(owner) }),
);

it("returns the owner of each entry and the oldest entries, after any additions and deletions", () => {
  fc.assert(
    fc.property(fc.array(change, { maxLength: 60 }), (changes) => {
      const owners = new EntryOwners();
      // The model: performs the same changes on a plain list.
      let plain: { entry: number; whose: string }[] = [];
      let newest = 5;
      for (const each of changes) {
        let found: number[] = [];
        let gone: number[] = [];
        if ("add" in each) {
          newest += 1 + each.gap;
          owners.add(newest, each.add);
          plain.push({ entry: newest, whose: each.add });
        } else if ("deleteUpTo" in each) {
          const upTo = newest - each.deleteUpTo;
          owners.deleteUpTo(upTo);
          plain = plain.filter(({ entry }) => entry > upTo);
        } else {
          const whom = new Set<string>(each.deleteOf);
          found = owners.deleteOf(whom);
          gone = plain.filter(({ whose }) => whom.has(whose)).map(({ entry }) => entry);
          plain = plain.filter(({ whose }) => !whom.has(whose));
        }
        expect(found).toEqual(gone);
        expect(owners.size).toBe(plain.length);
        for (const [most, before] of [1, 2, 99].flatMap((n) => [4, 0, -1].map((b) => [n, b]))) {
          const older = plain.filter(({ entry }) => entry < newest - (before ?? 0));
          const oldest = older.slice(0, most).at(-1)?.entry ?? 0;
          expect(owners.lastOfOldest(most ?? 0, newest - (before ?? 0))).toBe(oldest);
        }
      }
    }),
  );
});

it("reuses the slots of deleted entries", () => {
  const owners = new EntryOwners();
  for (let entry = 1; entry <= 20_000; entry++) {
    owners.add(entry, entry % 2 === 0 ? "a" : "b");
    if (entry > 100) owners.deleteUpTo(entry - 100);
  }
  expect(owners.size).toBe(100);
  expect(owners.lastOfOldest(1, Infinity)).toBe(19_901);
  expect(owners.deleteOf(new Set(["a"])).length).toBe(50);
  expect(owners.size).toBe(50);
});
