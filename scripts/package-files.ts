/** Completes a built npm package: manifest, README and licenses. */
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import type { Plugin } from "rolldown";

const ROOT = join(import.meta.dirname, "..");

/**
 * Adds README, license and manifest of a workspace, and the licenses of bundled packages. The
 * manifest has the fields of `publishConfig`, and nothing that only the repository needs.
 * @param folder of the workspace
 */
export function packageFiles(folder: string): Plugin {
  return {
    name: "package-files",
    async generateBundle(_options, bundle) {
      const manifest = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
      const { private: _private, scripts: _scripts, devDependencies: _dev, ...rest } = manifest;
      const { publishConfig, ...fields } = rest;
      const files: Record<string, string> = {
        "package.json": `${JSON.stringify({ ...fields, ...publishConfig }, null, 2)}\n`,
        "README.md": await readFile(join(folder, "README.md"), "utf8"),
        LICENSE: await readFile(join(ROOT, "LICENSE"), "utf8"),
      };
      const modules = Object.values(bundle).flatMap((file) =>
        file.type === "chunk" ? file.moduleIds : [],
      );
      const licenses = await bundledLicenses(modules);
      if (licenses !== "") files["THIRD-PARTY-LICENSES"] = licenses;
      for (const [fileName, source] of Object.entries(files)) {
        this.emitFile({ type: "asset", fileName, source });
      }
    },
  };
}

/** @param modules paths of all bundled modules @returns the licenses of the packages among them */
async function bundledLicenses(modules: readonly string[]): Promise<string> {
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
