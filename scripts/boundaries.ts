/**
 * Import boundaries: which workspace may import which, and which globals the pure packages must not
 * use. The linter checks the same directions per file; this module also detects cycles.
 */

/** Source files by path from the project's root, such as `packages/maze/src/grid.ts`. */
export type Sources = ReadonlyMap<string, string>;

/**
 * What each workspace may import besides its own files. A name that ends in a colon or a slash
 * allows every import with that prefix. `benches` and `e2e` may import any workspace.
 */
const allowed: Record<string, readonly string[]> = {
  "packages/geometry": [],
  "packages/protocol": ["zod"],
  "packages/maze": ["@corridor/protocol", "zod"],
  "packages/program": ["@corridor/protocol", "zod"],
  "packages/client": ["@corridor/protocol"],
  "packages/conformance": ["@corridor/protocol"],
  "packages/challenge": [
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/simulation",
    "@noble/hashes/",
    "zod",
  ],
  "packages/report": ["@corridor/protocol", "papaparse", "zod"],
  "packages/coach": [
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/simulation",
  ],
  "packages/agent": [
    "@corridor/geometry",
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@modelcontextprotocol/server",
    "fast-png",
    "zod",
  ],
  "packages/mouse": ["@corridor/maze", "@corridor/protocol"],
  "packages/quickstarts": ["@corridor/protocol"],
  "packages/ros": ["@corridor/geometry", "@corridor/maze", "@corridor/protocol", "zod"],
  "packages/recording": [
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/simulation",
    "zod",
  ],
  "packages/link": [
    "@corridor/challenge",
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/recording",
    "zod",
  ],
  "packages/simulation": [
    "@corridor/geometry",
    "@corridor/maze",
    "@corridor/protocol",
    "matter-js",
  ],
  "apps/cli": [
    "@corridor/agent",
    "@corridor/challenge",
    "@corridor/client",
    "@corridor/client/bridge",
    "@corridor/coach",
    "@corridor/conformance",
    "@corridor/link",
    "@corridor/maze",
    "@corridor/mouse",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/report",
    "@corridor/ros",
    "@corridor/simulation",
    "@modelcontextprotocol/server/stdio",
    "leven",
    "node:",
    "ws",
  ],
  "apps/relay": [
    "@corridor/agent",
    "@corridor/challenge/document",
    "@corridor/link/project",
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/quickstarts",
    "@corridor/ros",
    "@modelcontextprotocol/server",
    "@redis/client",
    "express",
    "helmet",
    "node:",
    "leven",
    "marked",
    "pino",
    "prom-client",
    "saxes",
    "swagger-ui-dist",
    "vite",
    "ws",
    "zod",
    "zod-openapi",
  ],
  "apps/web": [
    "@corridor/challenge",
    "@corridor/challenge/document",
    "@corridor/client",
    "@corridor/client/host",
    "@corridor/client/learn",
    "@corridor/client/show",
    "@corridor/client/teach",
    "@corridor/client/watch",
    "@corridor/coach",
    "@corridor/geometry",
    "@corridor/link",
    "@corridor/link/project",
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/quickstarts",
    "@corridor/recording",
    "@corridor/report",
    "@corridor/simulation",
    "@fontsource-variable/",
    "i18next",
    "lucide",
    "react",
    "react-dom",
    "react-i18next",
    "uqr",
    "virtual:",
    "zundo",
    "zustand",
  ],
  examples: ["@corridor/client", "node:"],
};

/** The only file that may import the physics engine, and the type declarations for it. */
const ENGINE = "packages/simulation/src/physics/physics-world.ts";
const ENGINE_TYPES = "packages/simulation/src/physics/matter-parts.d.ts";

/** Packages that send requests and wait for responses. No result of a simulation depends on them. */
const networked: ReadonlySet<string> = new Set(["packages/client", "packages/conformance"]);

/**
 * Functions whose results differ between JavaScript engines or from one run to the next. Callers
 * pass time, randomness and sockets to the other packages.
 */
const impurePattern =
  /\bMath\.(?:sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|hypot|exp|expm1|log|log1p|log2|log10|pow|cbrt|random)\b|\*\*|\bnew Date\b|\bDate\.now\b|\bperformance\b|\bprocess\./;

/** Files that write code for other programs: their templates are text, not code of the package. */
const writers =
  /^packages\/(?:program\/src\/code-export\/\w+-code|quickstarts\/src\/\w+-texts)\.ts$/;

const importPattern =
  /(?:^|\n)\s*(?:import|export)\s[^;'"]*?from\s*"([^"]+)"|(?:^|\n)\s*import\s*"([^"]+)"|\bimport\(\s*"([^"]+)"/g;

/** @returns every violation of the boundaries, one sentence each */
export function violations(sources: Sources): string[] {
  const found: string[] = [];
  const graph = new Map<string, string[]>();
  for (const [path, text] of sources) {
    const source = writers.test(path) ? text.replace(/`[\s\S]*`/, "``") : text;
    const workspace = workspaceOf(path);
    const rules = allowed[workspace];
    if (rules === undefined) {
      found.push(`${path} is in a workspace that scripts/boundaries.ts does not list`);
      continue;
    }
    const targets: string[] = [];
    for (const name of importsOf(source)) {
      if (name.startsWith(".")) {
        const target = resolve(path, name);
        targets.push(target);
        if (workspaceOf(target) !== workspace) {
          found.push(`${path} reaches into ${target}: import the package by its name`);
        }
      } else if (!isAllowed(name, rules)) {
        found.push(`${path} imports ${name}, which ${workspace} must not import`);
      } else if (isEngine(name) && path !== ENGINE && path !== ENGINE_TYPES) {
        found.push(`${path} imports matter-js, which only ${ENGINE} may import`);
      }
    }
    graph.set(path, targets);
    if (path.startsWith("packages/") && !networked.has(workspace)) {
      const match = impurePattern.exec(withoutComments(source));
      if (match !== null) found.push(`${path} uses ${match[0]}, which a package must not use`);
    }
  }
  for (const cycle of cyclesOf(graph)) found.push(`cycle: ${cycle.join(" → ")}`);
  return found;
}

function isEngine(name: string): boolean {
  return name === "matter-js" || name.startsWith("matter-js/");
}

export function workspaceOf(path: string): string {
  const [top = "", name = ""] = path.split("/");
  return top === "packages" || top === "apps" ? `${top}/${name}` : top;
}

function isAllowed(name: string, rules: readonly string[]): boolean {
  return rules.some((rule) =>
    /[:/]$/.test(rule) ? name.startsWith(rule) : name === rule || isEntryOf(name, rule),
  );
}

/** `react-dom/client` belongs to `react-dom`; Corridor's packages list each entry point. */
function isEntryOf(name: string, rule: string): boolean {
  return !rule.startsWith("@corridor/") && name.startsWith(`${rule}/`);
}

export function importsOf(source: string): string[] {
  return [...withoutComments(source).matchAll(importPattern)].map(
    (match) => match[1] ?? match[2] ?? match[3] ?? "",
  );
}

export function withoutComments(source: string): string {
  return source.replaceAll(/\/\*[\s\S]*?\*\//g, "").replaceAll(/(^|\s)\/\/.*$/gm, "$1");
}

export function resolve(from: string, relative: string): string {
  const parts = from.split("/").slice(0, -1);
  for (const part of relative.split("/")) {
    if (part === "..") parts.pop();
    else if (part !== ".") parts.push(part);
  }
  return parts.join("/");
}

/** One cycle for each back edge of a depth-first search; type imports count too. */
function cyclesOf(graph: ReadonlyMap<string, readonly string[]>): string[][] {
  const cycles: string[][] = [];
  const done = new Set<string>();
  const visit = (path: string, trail: string[]): void => {
    const at = trail.indexOf(path);
    if (at >= 0) {
      cycles.push([...trail.slice(at), path]);
      return;
    }
    if (done.has(path)) return;
    for (const target of graph.get(path) ?? []) visit(target, [...trail, path]);
    done.add(path);
  };
  for (const path of graph.keys()) visit(path, []);
  return cycles;
}
