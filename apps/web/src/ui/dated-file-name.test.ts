import { expect, it } from "vitest";
import { datedFileName } from "./dated-file-name.ts";

const at = new Date(2026, 2, 5, 23, 59).getTime();

it.each([
  ["8B, Two mazes", "8b-two-mazes-2026-03-05"],
  ["", "report-2026-03-05"],
  ["x".repeat(200), `${"x".repeat(60)}-2026-03-05`],
])("a saved table is named by its lesson and its day: %s", (name, file) => {
  expect(datedFileName(name, at, "report")).toBe(file);
});
