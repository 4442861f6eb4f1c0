import { defineConfig } from "vitest/config";
import { components } from "./apps/web/components.config.ts";

const report = process.env["VITEST_JSON_REPORT"];

export default defineConfig({
  test: {
    // By default one core is left idle, which on CI's two cores is half of the machine.
    maxWorkers: "100%",
    projects: [
      {
        test: {
          name: "unit",
          include: [
            "packages/**/*.test.ts",
            "apps/**/*.test.ts",
            "scripts/**/*.test.ts",
            "benches/**/*.test.ts",
            "e2e/**/*.test.ts",
          ],
          exclude: ["**/node_modules/**", "**/dist/**"],
          testTimeout: 60_000,
        },
      },
      {
        // Tests that start processes: relays, Redis, Python, Java and others.
        test: {
          name: "integration",
          include: ["tests/integration/**/*.test.ts"],
          testTimeout: 60_000,
        },
      },
      components,
    ],
    ...(report === undefined ? {} : { outputFile: { json: report } }),
  },
});
