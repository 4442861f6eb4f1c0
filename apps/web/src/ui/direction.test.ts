/** Styles use logical start and end instead of left and right: the page also runs right-to-left. */
import { globSync, readFileSync } from "node:fs";
import { expect, it } from "vitest";

const source = new URL("../", import.meta.url);
const physical =
  /(^\s*|[{;]\s*)((margin|padding|border|scroll-(margin|padding))-(left|right)\S*|left|right|(text-align|float|clear): *(left|right)|border-(top|bottom)-(left|right)-radius)\s*[:;]/;

it.each(globSync("**/*.css", { cwd: source }))("%s mirrors", (file) => {
  const lines = readFileSync(new URL(file, source), "utf8").split("\n");
  const found = lines.flatMap((line, at) =>
    physical.test(line) ? [`${at + 1}: ${line.trim()}`] : [],
  );
  expect(found).toEqual([]);
});

it.each([
  "margin-left: 4px;",
  "  left: 0;",
  "text-align: right;",
  "border-left: 1px solid;",
  "border-top-left-radius: 4px;",
  "padding-right:0;",
])("%j would not", (line) => {
  expect(line).toMatch(physical);
});

it.each(["margin-inline-start: 4px;", "text-align: start;", ".left {", "grid-area: left;"])(
  "%j does",
  (line) => {
    expect(line).not.toMatch(physical);
  },
);
