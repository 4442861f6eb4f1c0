/**
 * `npm run test:faults`: injects each fault that the real service must survive, scenario by
 * scenario, with real processes and sockets. Prints a line for each goal. The exit code is 1 when a
 * goal is missed.
 *
 * npm run test:faults -- [--long] [--seed N] [--report FILE] [WORD ...]
 *
 * A WORD selects the scenarios with that word in their titles.
 */
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { cpus, loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { formatGoal } from "../../benches/core/goals.ts";
import { machineNow } from "./clock.ts";
import { passes, reportOf, type Result } from "./report.ts";
import { scenarios } from "./scenarios.ts";
import type { Scenario, ScenarioContext } from "./scenario.ts";

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    long: { type: "boolean", default: false },
    seed: { type: "string", default: "1" },
    report: { type: "string" },
  },
});
const isLong = values.long;
const seed = Number(values.seed);
const words = positionals.map((word) => word.toLowerCase());
const selected = scenarios.filter(
  ({ title }) => words.length === 0 || words.some((word) => title.toLowerCase().includes(word)),
);

const results: Result[] = [];
for (const scenario of selected) {
  results.push(await runScenario(scenario));
  // The report is written after each scenario: a long run may be interrupted.
  if (values.report !== undefined) writeFileSync(values.report, report());
}

const passed = results.filter(passes).length;
console.log(`\n${passed} of ${results.length} scenarios pass.`);
if (passed < results.length || selected.length === 0) process.exitCode = 1;
// Scenarios may leave handles open, so exit explicitly.
process.exit();

function report(): string {
  const [processor] = cpus();
  const kind = processor?.model.trim() || process.arch;
  return reportOf(results, {
    date: new Date().toISOString().slice(0, 10),
    machine: `${cpus().length} x ${kind}, ${process.platform}`,
    versions: `Node ${process.versions.node}`,
    isLong,
    seed,
  });
}

async function runScenario(scenario: Scenario): Promise<Result> {
  const { title } = scenario;
  const description = scenario.describe(isLong);
  console.log(`\n${title}: ${description}`);
  const folder = mkdtempSync(join(tmpdir(), "corridor-faults-"));
  const cleanups: (() => unknown)[] = [];
  const context: ScenarioContext = {
    isLong,
    seed,
    folder,
    log: (line) => console.log(`      ${line}`),
    onCleanup: (clean) => void cleanups.push(clean),
  };
  const startedAt = machineNow();
  const seconds = (): number => (machineNow() - startedAt) / 1000;
  try {
    const goals = await scenario.run(context);
    for (const goal of goals) console.log(formatGoal(goal));
    return { title, description: description, goals, seconds: seconds(), load: loadAverage() };
  } catch (error) {
    const fault = error instanceof Error ? (error.stack ?? error.message) : String(error);
    console.log(`FAIL  ${fault}`);
    const [message = ""] = fault.split("\n");
    return {
      title,
      description: description,
      goals: null,
      fault: message,
      seconds: seconds(),
      load: loadAverage(),
    };
  } finally {
    for (const clean of cleanups.toReversed()) await clean();
    rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

/** The load average of the whole machine in the last minute. */
function loadAverage(): number {
  return loadavg()[0] ?? NaN;
}
