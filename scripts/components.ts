/** `npm run test:components`: tests of components in Chromium. Arguments are passed on to Vitest. */
import { spawnSync } from "node:child_process";
import { requireHeadlessChromium } from "./chromium.ts";

try {
  requireHeadlessChromium();
  const args = ["run", "--project", "components", ...process.argv.slice(2)];
  const { status } = spawnSync("vitest", args, {
    stdio: "inherit",
    shell: process.platform === "win32",
  });
  process.exitCode = status ?? 1;
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}
