import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { join } from "node:path";

/** @param modules paths of all bundled modules @returns the licenses of the packages among them */
export async function bundledLicenses(modules: readonly string[]): Promise<string> {
  const folders = modules.flatMap(
    (path) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+(?=\/)/.exec(path.replaceAll("\\", "/")) ?? [],
  );
  const texts = [...new Set(folders)].toSorted().map(async (folder) => {
    const { name, version } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
    const file = ["LICENSE", "LICENSE.md", "license"]
      .map((each) => join(folder, each))
      .find((path) => existsSync(path));
    if (file === undefined) throw new Error(`${name} has no license file in ${folder}`);
    return `${name} ${version}\n\n${(await readFile(file, "utf8")).trim()}\n`;
  });
  return (await Promise.all(texts)).join("\n---\n\n");
}
