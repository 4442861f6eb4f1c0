/** Builds the npm package in dist: the command `corridor` as one file without dependencies. */
import { join } from "node:path";
import { defineConfig } from "rolldown";
import { packageFiles } from "../../scripts/package-files.ts";

const FOLDER = import.meta.dirname;

export default defineConfig({
  input: { corridor: join(FOLDER, "src/main.ts") },
  platform: "node",
  transform: { target: "node20.19" },
  output: { dir: join(FOLDER, "dist"), codeSplitting: false, cleanDir: true },
  plugins: [packageFiles(FOLDER)],
});
