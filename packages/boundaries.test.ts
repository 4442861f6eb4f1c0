import { globSync, readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { violations, type Sources } from "../scripts/boundaries.ts";

const root = new URL("../", import.meta.url).pathname;

function sourcesOnDisk(): Sources {
  const files = globSync(
    ["packages/*/src/**/*.ts", "apps/*/src/**/*.{ts,tsx}", "examples/**/*.ts"],
    {
      cwd: root,
      exclude: ["**/*.test.ts", "**/*.cases.ts", "**/testing/**", "**/node_modules/**"],
    },
  );
  return new Map(files.map((file) => [file, readFileSync(root + file, "utf8")]));
}

describe("the house", () => {
  it("keeps every import going down and every package pure", () => {
    const sources = sourcesOnDisk();
    expect(sources.size).toBeGreaterThan(50);
    expect(violations(sources)).toEqual([]);
  });
});

describe("a planted violation", () => {
  const maze = "packages/maze/src/a.ts";
  it.each<{ name: string; files: Record<string, string>; says: string }>([
    {
      name: "an import that goes up",
      files: { [maze]: 'import { Simulation } from "@corridor/simulation";' },
      says: `${maze} imports @corridor/simulation`,
    },
    {
      name: "an import of a neighbour",
      files: { [maze]: 'import type { Rule } from "@corridor/program";' },
      says: `${maze} imports @corridor/program`,
    },
    {
      name: "a dynamic import",
      files: { "packages/geometry/src/a.ts": 'const zod = await import("zod");' },
      says: "packages/geometry/src/a.ts imports zod",
    },
    {
      name: "a deep path into another package",
      files: { [maze]: 'export { x } from "@corridor/protocol/src/x.ts";' },
      says: `${maze} imports @corridor/protocol/src/x.ts`,
    },
    {
      name: "a relative path out of the workspace",
      files: { [maze]: 'import { x } from "../../program/src/x.ts";' },
      says: `${maze} reaches into packages/program/src/x.ts`,
    },
    {
      name: "a second file that knows the engine",
      files: { "packages/simulation/src/a.ts": 'import Matter from "matter-js";' },
      says: "packages/simulation/src/a.ts imports matter-js",
    },
    {
      name: "a cycle, though of types only",
      files: {
        [maze]: 'import type { B } from "./b.ts";',
        "packages/maze/src/b.ts": 'import type { A } from "./a.ts";',
      },
      says: "cycle: packages/maze/src/a.ts → packages/maze/src/b.ts → packages/maze/src/a.ts",
    },
    {
      name: "a sine",
      files: { "packages/geometry/src/a.ts": "const s = Math.sin(1);" },
      says: "packages/geometry/src/a.ts uses Math.sin",
    },
    {
      name: "a clock",
      files: { [maze]: "const t = Date.now();" },
      says: `${maze} uses Date.now`,
    },
    {
      name: "chance",
      files: { [maze]: "const r = Math.random();" },
      says: `${maze} uses Math.random`,
    },
  ])("is found: $name", ({ files, says }) => {
    expect(violations(new Map(Object.entries(files))).join("\n")).toContain(says);
  });
});
