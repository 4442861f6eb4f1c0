/**
 * Builds the npm package in `dist/`: each entry as one file, without other workspaces;
 * dts-bundle-generator adds the types. And `corridor.js`, which the relay serves: the main entry as
 * one file without dependencies.
 */
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { defineConfig, type Plugin, type RolldownOptions } from "rolldown";

const FOLDER = import.meta.dirname;
const ROOT = join(FOLDER, "../..");

export default defineConfig([
  entry("index", [packageFiles()]),
  entry("host"),
  entry("watch"),
  {
    input: join(FOLDER, "src/index.ts"),
    output: { file: join(ROOT, "apps/relay/dist/corridor.js"), minify: true },
  },
]);

function entry(name: string, plugins: Plugin[] = []): RolldownOptions {
  return {
    input: join(FOLDER, `src/${name}.ts`),
    external: ["zod"],
    output: { dir: join(FOLDER, "dist") },
    plugins,
  };
}

/** Adds README, license and manifest. The manifest has the fields of `publishConfig`. */
function packageFiles(): Plugin {
  return {
    name: "package-files",
    async generateBundle() {
      const manifest = JSON.parse(await readFile(join(FOLDER, "package.json"), "utf8"));
      const { private: _private, scripts: _scripts, devDependencies: _dev, ...rest } = manifest;
      const { publishConfig, ...fields } = rest;
      const files = {
        "package.json": `${JSON.stringify({ ...fields, ...publishConfig }, null, 2)}\n`,
        "README.md": await readFile(join(FOLDER, "README.md"), "utf8"),
        LICENSE: await readFile(join(ROOT, "LICENSE"), "utf8"),
      };
      for (const [fileName, source] of Object.entries(files)) {
        this.emitFile({ type: "asset", fileName, source });
      }
    },
  };
}
