import { globSync, readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { importsOf, violations, type Sources } from "../scripts/boundaries.ts";
import { layerViolations } from "../scripts/layers.ts";
import { testsThatKeepStubs, testsThatOpen } from "../scripts/test-kinds.ts";

const root = new URL("../", import.meta.url).pathname;

const sourceFiles = ["packages/*/src/**/*.ts", "apps/*/src/**/*.{ts,tsx}", "examples/**/*.ts"];
const testFiles = ["**/*.test.{ts,tsx}", "**/*.cases.ts", "**/cases/**", "**/testing/**"];

function sourcesOnDisk(...exclude: string[]): Sources {
  const files = globSync(sourceFiles, { cwd: root, exclude: ["**/node_modules/**", ...exclude] });
  return new Map(files.map((file) => [file, readFileSync(root + file, "utf8")]));
}

describe("imports between workspaces", () => {
  it("lead to lower layers only, and packages use no clock, randomness or environment", () => {
    const sources = sourcesOnDisk(...testFiles);
    expect(sources.size).toBeGreaterThan(50);
    expect(violations(sources)).toEqual([]);
  });

  it("keeps the folders of an app in layers, tests included", () => {
    expect(layerViolations(sourcesOnDisk())).toEqual([]);
  });
});

describe("unit tests", () => {
  const planted = "packages/boundaries.test.ts";
  const kinds = "**/*.{integration,exhaustive,component}.test.{ts,tsx}";
  const testsOnDisk = (...exclude: string[]): Sources => {
    const testSources = ["**/*.test.{ts,tsx}", "**/*.cases.ts", "**/{cases,testing}/**/*.{ts,tsx}"];
    const without = ["**/node_modules/**", "tests/**", ...exclude];
    const files = globSync(testSources, { cwd: root, exclude: without });
    return new Map(files.map((file) => [file, readFileSync(root + file, "utf8")]));
  };
  const starters = (sources: Sources): string[] =>
    [...sources]
      .filter(([, source]) =>
        importsOf(source).some((name) => /^node:child_process$|\/tests\/support\//.test(name)),
      )
      .map(([file]) => file);

  it("start no process: tests that do are in tests/integration", () => {
    const sources = testsOnDisk();
    expect(sources.size).toBeGreaterThan(200);
    expect(starters(sources)).toEqual([]);
  });

  it.each([
    'import { spawn } from "node:child_process";',
    'import { startRelayProcess } from "../../../tests/support/test-relay-process.ts";',
  ])("are found if they do: %s", (source) => {
    expect(starters(new Map([["apps/relay/src/a.test.ts", source]]))).toHaveLength(1);
  });

  it("open no socket and no SQLite file: tests that do end in .integration.test.ts", () => {
    const sources = testsOnDisk(kinds, planted);
    expect(sources.size).toBeGreaterThan(200);
    expect(testsThatOpen(sources)).toEqual([]);
  });

  it.each([
    'import { startTestRelay } from "./testing/test-relay.ts";',
    'import { connect } from "node:net";',
    'import { createServer } from "node:http";',
    'import { DatabaseSync } from "node:sqlite";',
    'import { SqliteRobotStore } from "./store/sqlite/sqlite-robot-store.ts";',
    "const server = app.listen(0);",
    'import { withRobot } from "./testing/robot.ts";',
  ])("are found if they do: %s", (source) => {
    const helper = 'import { openDatabase } from "../store/sqlite/file/sqlite-schema.ts";';
    const sources = {
      "apps/relay/src/a.test.ts": source,
      "apps/relay/src/testing/robot.ts": helper,
    };
    expect(testsThatOpen(new Map(Object.entries(sources)))).toEqual(["apps/relay/src/a.test.ts"]);
  });

  it("restore the timers, globals and methods that they replace", () => {
    expect(testsThatKeepStubs(testsOnDisk(kinds, planted))).toEqual([]);
  });

  it.each(["vi.useFakeTimers();", 'vi.stubGlobal("Intl", {});', 'vi.spyOn(Math, "random");'])(
    "are found if they do not: %s",
    (source) => {
      expect(testsThatKeepStubs(new Map([["apps/web/src/a.test.ts", source]]))).toHaveLength(1);
    },
  );
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
    {
      name: "chance in a writer of code, outside of its template",
      files: {
        "packages/program/src/code-export/a-code.ts":
          "const a = `Math.sin(1)`;\nconst r = Math.random();",
      },
      says: "packages/program/src/code-export/a-code.ts uses Math.random",
    },
  ])("is found: $name", ({ files, says }) => {
    expect(violations(new Map(Object.entries(files))).join("\n")).toContain(says);
  });
});

describe("a planted violation of an app's layers", () => {
  const layers = [["main.ts"], ["rooms/*"], ["base", "words"]];
  const app = "apps/web";
  it.each<{ name: string; files: Record<string, string>; says: string }>([
    {
      name: "an import that goes up",
      files: { "base/a.ts": 'import { b } from "../rooms/one/b.ts";' },
      says: "base must not import rooms/one",
    },
    {
      name: "an import that goes up in a test",
      files: { "base/a.test.ts": 'import { b } from "../rooms/one/b.ts";' },
      says: "base must not import rooms/one",
    },
    {
      name: "an import that goes up from a testing folder",
      files: { "base/testing/a.ts": 'import { b } from "../../main.ts";' },
      says: "base must not import main.ts",
    },
    {
      name: "an import of a neighbour",
      files: { "rooms/one/a.ts": 'import { b } from "../two/b.ts";' },
      says: "rooms/one must not import rooms/two",
    },
    {
      name: "an import of another unit of the layer",
      files: { "base/a.ts": 'import { b } from "../words/b.ts";' },
      says: "base must not import words",
    },
    {
      name: "the address of a worker in a higher layer",
      files: { "base/a.ts": 'new Worker(new URL("../rooms/one/b.ts", import.meta.url));' },
      says: "base must not import rooms/one",
    },
    {
      name: "a folder without a layer",
      files: { "other/a.ts": 'import { b } from "../base/b.ts";' },
      says: "lists no layer for other",
    },
    {
      name: "folders in a circle",
      files: {
        "base/a.ts": 'import { b } from "./inner/b.ts";',
        "base/inner/b.ts": 'import { c } from "../c.ts";',
      },
      says: "the folder base/inner is in a circle of imports",
    },
  ])("is found: $name", ({ files, says }) => {
    const found = layerViolations(sourcesIn(files), { [app]: { layers } });
    expect(found.join("\n")).toContain(says);
  });

  it("lets only tests import the folder that starts the whole app", () => {
    const rules = { layers, forTests: "testing" };
    const files = {
      "testing/start.ts": 'import { a } from "../main.ts";',
      "base/a.test.ts": 'import { b } from "../testing/start.ts";',
      "main.test.ts": 'import { a } from "./main.ts"; import { b } from "./testing/start.ts";',
    };
    expect(layerViolations(sourcesIn(files), { [app]: rules })).toEqual([]);
    const wrong = { "base/a.ts": 'import { b } from "../testing/start.ts";' };
    const found = layerViolations(sourcesIn(wrong), { [app]: rules });
    expect(found.join("\n")).toContain("base must not import testing");
  });

  it("allows imports that go down", () => {
    const files = {
      "main.ts": 'import { a } from "./rooms/one/a.ts"; import { b } from "./base/b.ts";',
      "rooms/one/a.ts": 'import { b } from "../../base/b.ts"; import { c } from "./c.ts";',
      "rooms/one/A.component.test.tsx": 'import { services } from "../../main.ts";',
    };
    expect(layerViolations(sourcesIn(files), { [app]: { layers } })).toEqual([]);
  });

  function sourcesIn(files: Record<string, string>): Sources {
    return new Map(Object.entries(files).map(([file, source]) => [`${app}/src/${file}`, source]));
  }
});
