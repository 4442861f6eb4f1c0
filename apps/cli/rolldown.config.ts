/**
 * Builds the npm package in dist: the command `corridor` as one file without dependencies. And
 * `grade.mjs`, which the relay serves: the command `grade` as one file.
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
  {
    ...node,
    input: join(FOLDER, "src/grade-main.ts"),
    output: { file: join(FOLDER, "../relay/dist/grade.mjs"), codeSplitting: false },
    plugins: [licenseComment()],
  },
]);
