/** The reference of the TypeScript library is what its doc comments say, and they say everything. */
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { groups, libraryReference, REFERENCE } from "./library-reference.ts";

const made = libraryReference();

it("is what the doc comments say: if not, run `npm run reference` and commit REFERENCE.md", () => {
  expect(readFileSync(REFERENCE, "utf8")).toBe(made.text);
});

it("has everything that the library exports", () => {
  expect(Object.values(groups).flat().sort()).toEqual(made.names.sort());
});

it("has words for each method, property, parameter, result and error", () => {
  expect(made.undocumented).toEqual([]);
});
