import { defineConfig } from "vitest/config";

const report = process.env["VITEST_JSON_REPORT"];

export default defineConfig({
  test: {
    include: [
      "packages/**/*.test.ts",
      "apps/**/*.test.ts",
      "scripts/**/*.test.ts",
      "benches/**/*.test.ts",
      "e2e/**/*.test.ts",
    ],
    exclude: ["**/node_modules/**", "**/dist/**"],
    testTimeout: 60_000,
    ...(report === undefined ? {} : { outputFile: { json: report } }),
  },
});
