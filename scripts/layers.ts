/**
 * Import direction between the folders inside an app. `boundaries.ts` checks the directions between
 * workspaces. Tests and testing folders obey the direction too.
 */
import { importsOf, resolve, withoutComments, type Sources } from "./boundaries.ts";
import { webExceptions } from "./layer-exceptions.ts";

/**
 * The units of each app by layer, from top to bottom. A file may import from its own unit and from
 * lower layers. A unit is a file or folder in `src`; `name/*` makes each folder in `name` a unit.
 */
export type Layers = readonly (readonly string[])[];

/** Violations that still exist. An entry without a violation is a violation itself. */
export interface Exceptions {
  /** pairs of units, such as `stage -> model` */
  imports: readonly string[];
  /** folders in a circle of imports */
  circles: readonly string[];
}

export interface AppLayers {
  layers: Layers;
  /** a folder of helpers that start the whole app: it may import all, and only tests import it */
  forTests?: string;
  exceptions?: Exceptions;
}

export const appLayers: Record<string, AppLayers> = {
  "apps/relay": {
    layers: [
      ["main.ts"],
      ["relay.ts"],
      ["app.ts", "backend.ts"],
      ["config.ts"],
      ["site"],
      ["gateways", "ops"],
      ["pairing", "short-links", "robots"],
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
    exceptions: webExceptions,
  },
};

const urlPattern = /\bnew URL\(\s*"(\.[^"]+\.tsx?)"/g;
const testPattern = /\.(?:test|cases)\.tsx?$|(?:^|\/)(?:cases|testing)\//;

/** @returns every violation of the layers, one sentence each */
export function layerViolations(sources: Sources, apps = appLayers): string[] {
  return Object.entries(apps).flatMap(([app, rules]) => [
    ...unitViolations(app, rules, sources),
    ...circleViolations(app, rules, sources),
  ]);
}

function unitViolations(
  app: string,
  { layers, forTests, exceptions }: AppLayers,
  sources: Sources,
): string[] {
  const excepted = exceptions?.imports ?? [];
  const found: string[] = [];
  const used = new Set<string>();
  const unlisted = new Set<string>();
  for (const [from, target] of importsIn(app, sources)) {
    const unit = unitOf(from, layers);
    const other = unitOf(target, layers);
    if (unit === forTests || (other === forTests && testPattern.test(from))) continue;
    const layer = layerOf(unit, layers);
    if (layer < 0) unlisted.add(unit);
    if (unit === other || (layer >= 0 && layer < layerOf(other, layers))) continue;
    const pair = `${unit} -> ${other}`;
    used.add(pair);
    if (excepted.includes(pair)) continue;
    found.push(`${app}: ${from} imports ${target}, but ${unit} must not import ${other}`);
  }
  for (const unit of unlisted) {
    if (excepted.some((pair) => pair.startsWith(`${unit} -> `))) continue;
    found.push(`${app}: scripts/layers.ts lists no layer for ${unit}`);
  }
  return [...found, ...unusedExceptions(app, excepted, used)];
}

/** Circles of folders inside a unit, and across units where the direction is excepted. */
function circleViolations(app: string, { exceptions }: AppLayers, sources: Sources): string[] {
  const excepted = exceptions?.circles ?? [];
  const graph = new Map<string, Set<string>>();
  for (const [from, target] of importsIn(app, sources)) {
    if (testPattern.test(from) || folderOf(from) === folderOf(target)) continue;
    const targets = graph.get(folderOf(from)) ?? new Set();
    graph.set(folderOf(from), targets.add(folderOf(target)));
  }
  const circular = [...graph.keys()].filter((folder) => reachable(graph, folder).has(folder));
  return [
    ...circular
      .filter((folder) => !excepted.includes(folder))
      .map((folder) => `${app}: the folder ${folder} is in a circle of imports`),
    ...unusedExceptions(app, excepted, new Set(circular)),
  ];
}

/** The imports between files of an app, as paths from its `src`; worker addresses count too. */
function* importsIn(app: string, sources: Sources): Generator<[from: string, target: string]> {
  const root = `${app}/src/`;
  for (const [path, source] of sources) {
    if (!path.startsWith(root)) continue;
    const urls = [...withoutComments(source).matchAll(urlPattern)].map(([, url = ""]) => url);
    for (const name of [...importsOf(source), ...urls]) {
      const target = name.startsWith(".") ? resolve(path, name) : "";
      if (target.startsWith(root)) yield [path.slice(root.length), target.slice(root.length)];
    }
  }
}

function unitOf(path: string, layers: Layers): string {
  // A test at the top belongs to its file.
  const [top = "", name = ""] = path.replace(/^([\w-]+)\.test\./, "$1.").split("/");
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

function unusedExceptions(
  app: string,
  excepted: readonly string[],
  used: ReadonlySet<string>,
): string[] {
  return excepted
    .filter((exception) => !used.has(exception))
    .map((exception) => `${app}: delete the exception "${exception}", nothing needs it`);
}
