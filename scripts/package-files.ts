/** Completes built files: manifest, README and licenses of an npm package, licenses of one file. */
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import type { Plugin } from "rolldown";
import { bundledLicenses } from "./bundled-licenses.ts";

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

/** Adds the licenses of bundled packages to the end of a single file. */
export function licenseComment(): Plugin {
  return {
    name: "license-comment",
    async generateBundle(_options, bundle) {
      for (const file of Object.values(bundle)) {
        if (file.type !== "chunk") continue;
        const licenses = await bundledLicenses(file.moduleIds);
        file.code += `\n/*! Contains these packages:\n\n${licenses.replaceAll("*/", "* /")}*/\n`;
      }
    },
  };
}
