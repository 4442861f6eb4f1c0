/**
 * `npm run test:faults`: breaks the real service in every way that it promises to stand, row by
 * row, with real processes and sockets. Prints a line for each goal; exit code 1 when one is
 * missed.
 *
 * npm run test:faults -- [--long] [--seed N] [--report FILE] [WORD ...]
 *
 * Words choose rows by their titles.
 */
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { cpus, loadavg, tmpdir } from "node:os";
import { join } from "node:path";
import { parseArgs } from "node:util";
import { formatGoal } from "../../benches/core/goals.ts";
import { machineNow } from "./clock.ts";
import { holds, reportOf, type Judged } from "./report.ts";
import { rows } from "./rows.ts";
import type { Row, Terms } from "./row.ts";

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
const wanted = positionals.map((word) => word.toLowerCase());
const chosen = rows.filter(
  ({ title }) => wanted.length === 0 || wanted.some((word) => title.toLowerCase().includes(word)),
);

const judged: Judged[] = [];
for (const row of chosen) {
  judged.push(await judge(row));
  // After each one: a long run may be ended before its time.
  if (values.report !== undefined) writeFileSync(values.report, report());
}

const held = judged.filter(holds).length;
console.log(`\n${held} of ${judged.length} rows hold.`);
if (held < judged.length || chosen.length === 0) process.exitCode = 1;
// What a row has left open ends here.
process.exit();

function report(): string {
  const [processor] = cpus();
  const kind = processor?.model.trim() || process.arch;
  return reportOf(judged, {
    date: new Date().toISOString().slice(0, 10),
    machine: `${cpus().length} x ${kind}, ${process.platform}`,
    versions: `Node ${process.versions.node}`,
    isLong,
    seed,
  });
}

async function judge(row: Row): Promise<Judged> {
  const { title } = row;
  const does = row.does(isLong);
  console.log(`\n${title}: ${does}`);
  const folder = mkdtempSync(join(tmpdir(), "corridor-faults-"));
  const cleaning: (() => unknown)[] = [];
  const terms: Terms = {
    isLong,
    seed,
    folder,
    say: (line) => console.log(`      ${line}`),
    after: (clean) => void cleaning.push(clean),
  };
  const began = machineNow();
  const seconds = (): number => (machineNow() - began) / 1000;
  try {
    const goals = await row.run(terms);
    for (const goal of goals) console.log(formatGoal(goal));
    return { title, does, goals, seconds: seconds(), load: loadOf() };
  } catch (error) {
    const fault = error instanceof Error ? (error.stack ?? error.message) : String(error);
    console.log(`FAIL  ${fault}`);
    const [words = ""] = fault.split("\n");
    return { title, does, goals: null, fault: words, seconds: seconds(), load: loadOf() };
  } finally {
    for (const clean of cleaning.toReversed()) await clean();
    rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

/**
 * Of the whole machine in the last minute: more than it has processors means that others were at
 * work, too.
 */
function loadOf(): number {
  return loadavg()[0] ?? NaN;
}
