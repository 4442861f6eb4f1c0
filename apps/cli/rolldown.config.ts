/**
 * Builds the npm package in dist: the command `corridor` as one file without dependencies. And two
 * files that the relay serves: `corridor-cli.mjs`, the same command, and `grade.mjs`, the command
 * `grade` alone.
 */
import { join } from "node:path";
import { defineConfig, type RolldownOptions } from "rolldown";
import { licenseComment, packageFiles } from "../../scripts/package-files.ts";

const FOLDER = import.meta.dirname;

const node: RolldownOptions = { platform: "node", transform: { target: "node20.19" } };

export default defineConfig([
  {
    ...node,
    input: { corridor: join(FOLDER, "src/main.ts") },
    output: { dir: join(FOLDER, "dist"), codeSplitting: false, cleanDir: true },
    plugins: [packageFiles(FOLDER)],
  },
  served("main", "corridor-cli"),
  served("grade-main", "grade"),
]);

function served(entry: string, name: string): RolldownOptions {
  return {
    ...node,
    input: join(FOLDER, `src/${entry}.ts`),
    output: { file: join(FOLDER, `../relay/dist/${name}.mjs`), codeSplitting: false },
    plugins: [licenseComment()],
  };
}
