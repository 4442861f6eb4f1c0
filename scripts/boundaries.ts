/**
 * Who may import whom, and what the pure packages may not touch. The table is the house's plan; the
 * linter holds the same directions file by file, this looks at the whole.
 */

/** Source files by path from the project's root, such as `packages/maze/src/grid.ts`. */
export type Sources = ReadonlyMap<string, string>;

/** What each workspace may import besides its own files. A name with a colon allows all that begins so. */
const allowed: Record<string, readonly string[]> = {
  "packages/geometry": [],
  "packages/protocol": ["zod"],
  "packages/maze": ["@corridor/protocol", "zod"],
  "packages/program": ["@corridor/protocol", "zod"],
  "packages/client": ["@corridor/protocol"],
  "packages/challenge": [
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/simulation",
    "zod",
  ],
  "packages/coach": [
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/simulation",
  ],
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
  ],
  "packages/simulation": [
    "@corridor/geometry",
    "@corridor/maze",
    "@corridor/protocol",
    "matter-js",
  ],
  "apps/cli": [
    "@corridor/coach",
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/simulation",
    "node:",
  ],
  "apps/conformance": ["@corridor/protocol", "node:"],
  "apps/relay": [
    "@corridor/challenge/document",
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@redis/client",
    "express",
    "helmet",
    "node:",
    "leven",
    "marked",
    "pino",
    "prom-client",
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
    "@corridor/client/watch",
    "@corridor/coach",
    "@corridor/geometry",
    "@corridor/link",
    "@corridor/maze",
    "@corridor/program",
    "@corridor/protocol",
    "@corridor/recording",
    "@corridor/simulation",
    "@fontsource-variable/",
    "i18next",
    "lucide-react",
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

/** The one file that may know the engine, and the types of the engine's parts that it imports. */
const ENGINE = "packages/simulation/src/physics/physics-world.ts";
const ENGINE_TYPES = "packages/simulation/src/physics/matter-parts.d.ts";

/**
 * Not the same bits in every engine, or not the same at all from one run to the next. The packages
 * are given time, randomness and sockets.
 */
const impure =
  /\bMath\.(?:sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|hypot|exp|expm1|log|log1p|log2|log10|pow|cbrt|random)\b|\*\*|\bnew Date\b|\bDate\.now\b|\bperformance\b|\bprocess\./;

const importPattern =
  /(?:^|\n)\s*(?:import|export)\s[^;'"]*?from\s*"([^"]+)"|(?:^|\n)\s*import\s*"([^"]+)"|\bimport\(\s*"([^"]+)"/g;

/** Everything that breaks the plan, one sentence each; empty when the house is straight. */
export function violations(sources: Sources): string[] {
  const found: string[] = [];
  const graph = new Map<string, string[]>();
  for (const [path, source] of sources) {
    const workspace = workspaceOf(path);
    const rules = allowed[workspace];
    if (rules === undefined) {
      found.push(`${path} is in no workspace of the plan`);
      continue;
    }
    const targets: string[] = [];
    for (const name of importsOf(source)) {
      if (name.startsWith(".")) {
        const target = resolve(path, name);
        targets.push(target);
        if (workspaceOf(target) !== workspace) found.push(`${path} reaches into ${target}`);
      } else if (!isAllowed(name, rules)) {
        found.push(`${path} imports ${name}, which ${workspace} may not`);
      } else if (isEngine(name) && path !== ENGINE && path !== ENGINE_TYPES) {
        found.push(`${path} imports matter-js, which only ${ENGINE} may`);
      }
    }
    graph.set(path, targets);
    // The client works with networks, not with ticks: no bits depend on it.
    if (path.startsWith("packages/") && workspace !== "packages/client") {
      const match = impure.exec(withoutComments(source));
      if (match !== null) found.push(`${path} uses ${match[0]}, which a package may not`);
    }
  }
  for (const cycle of cyclesOf(graph)) found.push(`cycle: ${cycle.join(" → ")}`);
  return found;
}

function isEngine(name: string): boolean {
  return name === "matter-js" || name.startsWith("matter-js/");
}

function workspaceOf(path: string): string {
  const [top = "", name = ""] = path.split("/");
  return top === "packages" || top === "apps" ? `${top}/${name}` : top;
}

function isAllowed(name: string, rules: readonly string[]): boolean {
  return rules.some((rule) =>
    /[:/]$/.test(rule) ? name.startsWith(rule) : name === rule || isEntryOf(name, rule),
  );
}

/** `react-dom/client` belongs to `react-dom`; our own packages have the entries that they name. */
function isEntryOf(name: string, rule: string): boolean {
  return !rule.startsWith("@corridor/") && name.startsWith(`${rule}/`);
}

function importsOf(source: string): string[] {
  return [...withoutComments(source).matchAll(importPattern)].map(
    (match) => match[1] ?? match[2] ?? match[3] ?? "",
  );
}

function withoutComments(source: string): string {
  return source.replaceAll(/\/\*[\s\S]*?\*\//g, "").replaceAll(/(^|\s)\/\/.*$/gm, "$1");
}

function resolve(from: string, relative: string): string {
  const parts = from.split("/").slice(0, -1);
  for (const part of relative.split("/")) {
    if (part === "..") parts.pop();
    else if (part !== ".") parts.push(part);
  }
  return parts.join("/");
}

/** One cycle for each way back that a depth-first walk meets; type imports count too. */
function cyclesOf(graph: ReadonlyMap<string, readonly string[]>): string[][] {
  const cycles: string[][] = [];
  const done = new Set<string>();
  const walk = (path: string, trail: string[]): void => {
    const at = trail.indexOf(path);
    if (at >= 0) {
      cycles.push([...trail.slice(at), path]);
      return;
    }
    if (done.has(path)) return;
    for (const target of graph.get(path) ?? []) walk(target, [...trail, path]);
    done.add(path);
  };
  for (const path of graph.keys()) walk(path, []);
  return cycles;
}
