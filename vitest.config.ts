import { defineConfig } from "vitest/config";
import { components } from "./apps/web/components.config.ts";

const report = process.env["VITEST_JSON_REPORT"];

const folders = "{packages,apps,scripts,benches,e2e}";
const integration = `${folders}/**/*.integration.test.ts`;
const exhaustive = `${folders}/**/*.exhaustive.test.ts`;
const exclude = ["**/node_modules/**", "**/dist/**"];

export default defineConfig({
  test: {
    // By default one core is left idle, which on CI's two cores is half of the machine.
    maxWorkers: "100%",
    projects: [
      {
        test: {
          name: "unit",
          include: [`${folders}/**/*.test.ts`],
          exclude: [...exclude, integration, exhaustive],
          // Modules load once per worker. Tests restore the globals and timers that they replace.
          isolate: false,
          testTimeout: 60_000,
        },
      },
      {
        // Sweeps over many programs, mazes and runs.
        test: {
          name: "exhaustive",
          include: [exhaustive],
          exclude,
          isolate: false,
          testTimeout: 60_000,
        },
      },
      {
        // Tests that start relays, listen on sockets or open SQLite files, and in
        // tests/integration those that start processes: relays, Redis, Python, Java and others.
        test: {
          name: "integration",
          include: [integration, "tests/integration/**/*.test.ts"],
          exclude,
          // As in the unit tests. Loading the relay's modules for each file takes two seconds of
          // processor time, which is two fifths of the tests of its gateways.
          isolate: false,
          testTimeout: 180_000,
          hookTimeout: 60_000,
        },
      },
      components,
    ],
    ...(report === undefined ? {} : { outputFile: { json: report } }),
  },
});
