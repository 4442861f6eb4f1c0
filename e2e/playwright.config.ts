import { defineConfig } from "playwright/test";
import { chromiumArguments, requireHeadlessChromium } from "../scripts/chromium.ts";

const report = process.env["PLAYWRIGHT_JSON_OUTPUT_NAME"];

export default defineConfig({
  testDir: ".",
  testMatch: "**/*.spec.ts",
  fullyParallel: true,
  // On two cores: three tests leave a fifth of the processors idle, because they wait for robots.
  workers: 4,
  // A busy machine with slow cores has needed four times as long as others.
  timeout: 240_000,
  expect: { timeout: 45_000 },
  forbidOnly: process.env["CI"] !== undefined,
  reporter: report === undefined ? "list" : [["list"], ["json", { outputFile: report }]],
  outputDir: "../test-results",
  use: {
    browserName: "chromium",
    actionTimeout: 45_000,
    viewport: { width: 1440, height: 900 },
    permissions: ["clipboard-read", "clipboard-write"],
    // Tests load pages from the relay directly. Only offline.spec.ts covers the service worker.
    serviceWorkers: "block",
    // Drawing animations takes a tenth of a test's time. Tests of motion use `withMotion`.
    contextOptions: { reducedMotion: "reduce" },
    // Tracing takes a third of a test's time. Turn it on with `--trace on`.
    screenshot: "only-on-failure",
    launchOptions: { executablePath: requireHeadlessChromium(), args: [...chromiumArguments] },
  },
});
