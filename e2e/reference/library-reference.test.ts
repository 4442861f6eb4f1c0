/**
 * REFERENCE.md of the TypeScript library matches its doc comments, and the comments are complete.
 */
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { groups, libraryReference, REFERENCE } from "./library-reference.ts";

const reference = libraryReference();

it("matches the doc comments: if not, run `npm run reference` and commit REFERENCE.md", () => {
  expect(readFileSync(REFERENCE, "utf8")).toBe(reference.text);
});

it("lists every name that the library exports", () => {
  expect(Object.values(groups).flat().sort()).toEqual(reference.names.sort());
});

it("documents each method, property, parameter, result and error", () => {
  expect(reference.undocumented).toEqual([]);
});
