/**
 * Import direction between the folders inside an app. `boundaries.ts` checks the directions between
 * workspaces. Tests and testing folders obey the direction too.
 */
import { importsOf, resolve, withoutComments, type Sources } from "./boundaries.ts";

/**
 * The units of each app by layer, from top to bottom. A file may import from its own unit and from
 * lower layers. A unit is a file or folder in `src`; `name/*` makes each folder in `name` a unit.
 */
export type Layers = readonly (readonly string[])[];

export interface AppLayers {
  layers: Layers;
  /** a folder of helpers that start the whole app: it may import all, and only tests import it */
  forTests?: string;
}

export const appLayers: Record<string, AppLayers> = {
  "apps/relay": {
    layers: [
      ["main.ts"],
      ["relay.ts"],
      ["app.ts", "open-backend.ts"],
      ["redis-backend.ts"],
      ["config.ts", "backend.ts"],
      ["site"],
      ["gateways", "ops"],
      ["pairing", "short-links", "robots", "classes"],
      ["bus"],
      ["store"],
      ["commands", "platform"],
    ],
    forTests: "testing",
  },
  "apps/web": {
    layers: [
      ["main.tsx"],
      ["shell"],
      ["features/*"],
      ["model"],
      ["simulator"],
      ["stage"],
      ["ui", "text"],
    ],
  },
};

const urlPattern = /\bnew URL\(\s*"(\.[^"]+\.tsx?)"/g;
const testPattern = /\.(?:test|cases)\.tsx?$|(?:^|\/)(?:cases|testing)\//;
/** Renders a component with the services of the whole page, so it is above every layer. */
const componentTestPattern = /\.component\.test\.tsx$/;

/** @returns every violation of the layers, one sentence each */
export function layerViolations(sources: Sources, apps = appLayers): string[] {
  return Object.entries(apps).flatMap(([app, rules]) => [
    ...unitViolations(app, rules, sources),
    ...circleViolations(app, sources),
  ]);
}

function unitViolations(app: string, { layers, forTests }: AppLayers, sources: Sources): string[] {
  const found: string[] = [];
  const unlisted = new Set<string>();
  for (const [from, target] of importsIn(app, sources)) {
    const unit = unitOf(from, layers);
    const other = unitOf(target, layers);
    if (unit === forTests || (other === forTests && testPattern.test(from))) continue;
    const layer = layerOf(unit, layers);
    if (layer < 0) unlisted.add(unit);
    if (unit === other || (layer >= 0 && layer < layerOf(other, layers))) continue;
    found.push(`${app}: ${from} imports ${target}, but ${unit} must not import ${other}`);
  }
  for (const unit of unlisted) {
    found.push(`${app}: scripts/layers.ts lists no layer for ${unit}`);
  }
  return found;
}

/** Circles of folders; only folders of one unit can be in a circle if the layers hold. */
function circleViolations(app: string, sources: Sources): string[] {
  const graph = new Map<string, Set<string>>();
  for (const [from, target] of importsIn(app, sources)) {
    if (testPattern.test(from) || folderOf(from) === folderOf(target)) continue;
    const targets = graph.get(folderOf(from)) ?? new Set();
    graph.set(folderOf(from), targets.add(folderOf(target)));
  }
  return [...graph.keys()]
    .filter((folder) => reachable(graph, folder).has(folder))
    .map((folder) => `${app}: the folder ${folder} is in a circle of imports`);
}

/** The imports between files of an app, as paths from its `src`; worker addresses count too. */
function* importsIn(app: string, sources: Sources): Generator<[from: string, target: string]> {
  const root = `${app}/src/`;
  for (const [path, source] of sources) {
    if (!path.startsWith(root) || componentTestPattern.test(path)) continue;
    const urls = [...withoutComments(source).matchAll(urlPattern)].map(([, url = ""]) => url);
    for (const name of [...importsOf(source), ...urls]) {
      const target = name.startsWith(".") ? resolve(path, name) : "";
      if (target.startsWith(root)) yield [path.slice(root.length), target.slice(root.length)];
    }
  }
}

function unitOf(path: string, layers: Layers): string {
  // A test at the top belongs to its file.
  const [top = "", name = ""] = path
    .replace(/^([\w-]+)(?:\.integration|\.exhaustive)?\.test\./, "$1.")
    .split("/");
  return layers.some((layer) => layer.includes(`${top}/*`)) ? `${top}/${name}` : top;
}

function layerOf(unit: string, layers: Layers): number {
  const [top = ""] = unit.split("/");
  return layers.findIndex((layer) => layer.includes(unit) || layer.includes(`${top}/*`));
}

function folderOf(path: string): string {
  return path.includes("/") ? path.slice(0, path.lastIndexOf("/")) : ".";
}

/** The folders that one imports, directly or through others. */
function reachable(graph: ReadonlyMap<string, ReadonlySet<string>>, start: string): Set<string> {
  const found = new Set<string>();
  const open = [start];
  for (let folder = open.pop(); folder !== undefined; folder = open.pop()) {
    for (const target of graph.get(folder) ?? []) {
      if (found.has(target)) continue;
      found.add(target);
      open.push(target);
    }
  }
  return found;
}
