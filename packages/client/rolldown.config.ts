/**
 * Builds the npm package in `dist/`: each entry as one file, without other workspaces;
 * dts-bundle-generator adds the types. And `corridor.js`, which the relay serves: the main entry as
 * one file without dependencies.
 */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { defineConfig, type Plugin, type RolldownOptions } from "rolldown";
import { packageFiles } from "../../scripts/package-files.ts";

const FOLDER = import.meta.dirname;
const ROOT = join(FOLDER, "../..");

/** An uncaught error prints a short line of the source, and its class by its name. */
const READABLE = { compress: true, mangle: false, codegen: { removeWhitespace: false } };

/** The license of zod, which is part of corridor.js, demands that copies contain its text. */
const ZOD_LICENSE = `/*! Contains zod:

${readFileSync(join(ROOT, "node_modules/zod/LICENSE"), "utf8")}*/`;

export default defineConfig([
  entry("index", [packageFiles(FOLDER)]),
  entry("host"),
  entry("learn"),
  entry("show"),
  entry("teach"),
  entry("watch"),
  {
    input: join(FOLDER, "src/index.ts"),
    output: {
      file: join(ROOT, "apps/relay/dist/corridor.js"),
      minify: READABLE,
      postBanner: ZOD_LICENSE,
    },
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
