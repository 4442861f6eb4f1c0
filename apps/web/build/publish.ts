/**
 * Builds beside the served folder and moves the finished files into it. A relay that runs during a
 * build serves the old page or the new one, and never a missing file. The parts of the new page are
 * moved before the page itself. The files of the previous build stay for pages that are open and
 * load a part later.
 */
import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import { dirname, join } from "node:path";
import type { Plugin } from "vite";

/** Inside the served folder: the relay does not serve names that start with a dot. */
const BUILT = ".next";
const LIST = ".published.json";

export function publish(): Plugin {
  let served = "";
  return {
    name: "corridor-publish",
    apply: "build",
    config: () => ({ build: { outDir: join("dist", BUILT), emptyOutDir: true } }),
    configResolved(config) {
      served = join(config.root, "dist");
    },
    // Runs after compression, which writes the last files.
    closeBundle: {
      order: "post",
      sequential: true,
      handler(error) {
        if (error === undefined) publishFiles(join(served, BUILT), served);
      },
    },
  };
}

/**
 * Moves all files of a finished build into the served folder.
 * @param built folder of the build, deleted afterwards
 */
export function publishFiles(built: string, served: string): void {
  const before = publishedFiles(served);
  const files = filesIn(built);
  const isPart = (file: string): boolean => file.startsWith("assets");
  // The names of parts contain a hash of their content, so that a new part never replaces an old
  // one.
  for (const file of files.toSorted((a, b) => Number(isPart(b)) - Number(isPart(a)))) {
    const to = join(served, file);
    mkdirSync(dirname(to), { recursive: true });
    renameSync(join(built, file), to);
  }
  rmSync(built, { recursive: true });
  const current = new Set([...files, ...before.filter(isPart)]);
  for (const file of filesIn(served)) {
    if (!current.has(file) && file !== LIST) rmSync(join(served, file));
  }
  writeFileSync(join(served, LIST), JSON.stringify(files));
}

/** The files of the previous build, if any. */
function publishedFiles(served: string): string[] {
  const list = join(served, LIST);
  if (!existsSync(list)) return [];
  const files: unknown = JSON.parse(readFileSync(list, "utf8"));
  return Array.isArray(files) ? files.filter((file) => typeof file === "string") : [];
}

function filesIn(folder: string): string[] {
  return readdirSync(folder, { recursive: true, encoding: "utf8" }).filter((file) =>
    statSync(join(folder, file)).isFile(),
  );
}
