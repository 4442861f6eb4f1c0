/** Readers have two minutes: documents that everybody reads stay short. */
import { globSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { expect, it } from "vitest";

const ROOT = join(import.meta.dirname, "..");

it.each([
  { pattern: "README.md", most: 150 },
  { pattern: "docs/performance.md", most: 150 },
  { pattern: "CHANGELOG.md", most: 40 },
  { pattern: "docs/adr/*.md", most: 39 },
])("$pattern has at most $most lines", ({ pattern, most }) => {
  const files = globSync(pattern, { cwd: ROOT });
  expect(files).not.toEqual([]);
  const tooLong = files.filter((file) => {
    const lines = readFileSync(join(ROOT, file), "utf8").trimEnd().split("\n");
    return lines.length > most;
  });
  expect(tooLong).toEqual([]);
});
