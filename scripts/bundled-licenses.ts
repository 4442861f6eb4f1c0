import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { join } from "node:path";

/** Marks code of another package that a package has copied into a file of its own. */
const COPIED = /^\/\/#region .*\/\.pnpm\/((?:@[^+@/]+\+)?[^+@/]+)@(\d[^_/]*)/gm;
/** Copied packages that are not installed, and an installed one of the same author and license. */
const SAME_LICENSE: Readonly<Record<string, string>> = { "ajv-formats": "ajv" };

/**
 * @param modules paths of all bundled modules
 * @returns the licenses of the packages among them, and of those that they contain
 */
export async function bundledLicenses(modules: readonly string[]): Promise<string> {
  const found = new Map<string, () => Promise<string>>();
  for (const path of modules.map((module) => module.replaceAll("\\", "/"))) {
    const [folder, root = ""] = /^(.*node_modules\/)(?:@[^/]+\/)?[^/]+(?=\/)/.exec(path) ?? [];
    if (folder === undefined) continue;
    found.set(folder, () => licenseOf(folder));
    for (const { name, version } of await copiedInto(path)) {
      found.set(join(root, name), () => copiedLicense(root, name, version));
    }
  }
  const sorted = [...found].toSorted(([a], [b]) => (a < b ? -1 : 1));
  return (await Promise.all(sorted.map(([, read]) => read()))).join("\n---\n\n");
}

async function copiedInto(path: string): Promise<{ name: string; version: string }[]> {
  // Bundlers add modules of their own, which are no files.
  if (!existsSync(path)) return [];
  const source = await readFile(path, "utf8");
  return [...source.matchAll(COPIED)].map(([, name = "", version = ""]) => ({
    name: name.replace("+", "/"),
    version,
  }));
}

async function licenseOf(folder: string): Promise<string> {
  const { name, version } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
  return `${name} ${version}\n\n${await licenseIn(folder, name)}`;
}

async function copiedLicense(root: string, name: string, version: string): Promise<string> {
  return `${name} ${version}\n\n${await licenseIn(join(root, SAME_LICENSE[name] ?? name), name)}`;
}

async function licenseIn(folder: string, name: string): Promise<string> {
  const file = ["LICENSE", "LICENSE.md", "license"]
    .map((each) => join(folder, each))
    .find((path) => existsSync(path));
  if (file === undefined) throw new Error(`${name} has no license file in ${folder}`);
  return `${(await readFile(file, "utf8")).trim()}\n`;
}
