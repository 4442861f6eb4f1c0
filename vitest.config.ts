import { defineConfig } from "vitest/config";
import { BaseSequencer, type TestSpecification } from "vitest/node";
import { components } from "./apps/web/components.config.ts";

const report = process.env["VITEST_JSON_REPORT"];

const folders = "{packages,apps,scripts,benches,e2e}";
const integration = `${folders}/**/*.integration.test.ts`;
const exhaustive = `${folders}/**/*.exhaustive.test.ts`;
const exclude = ["**/node_modules/**", "**/dist/**"];

/**
 * Small files that take over half a minute. Vitest starts large files first, so without this list they
 * run last, and most of the machine waits for them.
 */
const longTests = /\/(delivery-faults|right-wall|bad-network|cxf|conformance\/gateways)\./;

class LongTestsFirst extends BaseSequencer {
  override async sort(files: TestSpecification[]): Promise<TestSpecification[]> {
    const bySize = await super.sort(files);
    const isLong = ({ moduleId }: TestSpecification): boolean => longTests.test(moduleId);
    return [...bySize.filter(isLong), ...bySize.filter((file) => !isLong(file))];
  }
}

export default defineConfig({
  test: {
    sequence: { sequencer: LongTestsFirst },
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
