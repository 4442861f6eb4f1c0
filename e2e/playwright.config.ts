import { defineConfig } from "playwright/test";
import { chromiumArguments, requireChromium } from "../scripts/chromium.ts";

const report = process.env["PLAYWRIGHT_JSON_OUTPUT_NAME"];

export default defineConfig({
  testDir: ".",
  testMatch: "**/*.spec.ts",
  fullyParallel: true,
  workers: 2,
  timeout: 60_000,
  expect: { timeout: 15_000 },
  // A machine that is busy with others may swallow a tap; the summary names every test that needed this.
  retries: 1,
  forbidOnly: process.env["CI"] !== undefined,
  reporter: report === undefined ? "list" : [["list"], ["json", { outputFile: report }]],
  outputDir: "../test-results",
  use: {
    browserName: "chromium",
    actionTimeout: 15_000,
    viewport: { width: 1440, height: 900 },
    permissions: ["clipboard-read", "clipboard-write"],
    // Journeys go to the relay itself; offline.spec.ts is about the service worker.
    serviceWorkers: "block",
    // A trace takes a third of the time of a test; `--trace on` makes one where it is needed.
    screenshot: "only-on-failure",
    launchOptions: { executablePath: requireChromium(), args: [...chromiumArguments] },
  },
});
