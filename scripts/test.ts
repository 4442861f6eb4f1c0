/**
 * `npm test`: types, lint, format, unused code, audit, unit tests, Python tests, build, end-to-end tests.
 * Every stage runs even when one before it failed; the last line counts all of them.
 */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { audit } from "./audit.ts";
import { requireChromium } from "./chromium.ts";
import { offerJava } from "./java.ts";
import { pythonTests, requirePython, requirePythonTools } from "./python.ts";
import { requireRedis } from "./redis-server.ts";

interface Counts {
  passed: number;
  failed: number;
  skipped: number;
  /** of the passed, how many did so at the second try only */
  flaky?: number;
}

const folder = mkdtempSync(join(tmpdir(), "corridor-test-"));
const total = { passed: 0, failed: 0, skipped: 0, flaky: 0 };

const requirements = [
  check("what the tests need", requirePython),
  check("browser", requireChromium),
].every(Boolean);
// Without it the tests that need it are skipped: that must not pass for good.
if (!check("Redis", requireRedis)) add("Redis", { passed: 0, failed: 1, skipped: 0 });
offerJava();
stage("types", ["tsc", "-b"]);
stage("lint", ["oxlint", "--max-warnings", "0"]);
stage("format", ["oxfmt", "--check"]);
stage("unused code", ["knip"]);
audited();
counted("unit", ["vitest", "run", "--reporter=default", "--reporter=json"], vitestCounts);
if (check("what the Python tests need", requirePythonTools)) {
  counted("python", [...pythonTests], junitCounts);
} else {
  add("python", { passed: 0, failed: 1, skipped: 0 });
}
const isBuilt = stage("build", ["vite", "build", "apps/web"]);
if (requirements && isBuilt) {
  const words = ["playwright", "test", "--config", "e2e/playwright.config.ts"];
  counted("end to end", words, playwrightCounts);
} else {
  add("end to end", { passed: 0, failed: 1, skipped: 0 });
}
rmSync(folder, { recursive: true });

if (total.skipped > 0) {
  process.stdout.write(
    `\n${total.skipped} skipped: this machine or its registry lacks what they need\n`,
  );
}
if (total.flaky > 0) {
  process.stdout.write(`\n${total.flaky} passed at the second try only: look at them above\n`);
}
process.stdout.write(`\n${total.passed} passed, ${total.failed} failed\n`);
process.exitCode = total.failed > 0 ? 1 : 0;

/** A stage that passes or fails as a whole. */
function stage(name: string, words: string[]): boolean {
  const isGood = run(name, words, {}) === 0;
  add(name, { passed: isGood ? 1 : 0, failed: isGood ? 0 : 1, skipped: 0 });
  return isGood;
}

/** Not every registry tells what is known of what it has. */
function audited(): void {
  process.stdout.write("\n== audit: npm audit\n");
  const { verdict, words } = audit();
  process.stdout.write(`${words}\n`);
  const counts = { passed: 0, failed: 0, skipped: 0 };
  if (verdict === "unknown") counts.skipped = 1;
  else counts[verdict] = 1;
  add("audit", counts);
}

/** A test runner that writes its report to a file, from which its tests are counted. */
function counted(name: string, words: string[], countsOf: (report: string) => Counts): void {
  const file = join(folder, `${name.replaceAll(" ", "-")}.report`);
  const code = run(name, words, {
    VITEST_JSON_REPORT: file,
    PLAYWRIGHT_JSON_OUTPUT_NAME: file,
    PYTEST_ADDOPTS: `--junitxml=${file}`,
  });
  let counts: Counts;
  try {
    counts = countsOf(readFileSync(file, "utf8"));
  } catch {
    counts = { passed: 0, failed: 1, skipped: 0 };
  }
  // A runner can fail outside of any test: a file that does not load, a server that does not start.
  if (code !== 0 && counts.failed === 0) counts.failed = 1;
  if (counts.passed === 0 && counts.failed === 0) counts.failed = 1;
  add(name, counts);
}

function run(name: string, [command = "", ...words]: string[], extra: NodeJS.ProcessEnv): number {
  process.stdout.write(`\n== ${name}: ${[command, ...words].join(" ")}\n`);
  const { status } = spawnSync(command, words, {
    stdio: "inherit",
    env: { ...process.env, ...extra },
    shell: process.platform === "win32",
  });
  return status ?? 1;
}

function check(name: string, requirement: () => unknown): boolean {
  try {
    requirement();
    return true;
  } catch (error) {
    process.stdout.write(`\n== ${name}\n${error instanceof Error ? error.message : "missing"}\n`);
    return false;
  }
}

function add(name: string, counts: Counts): void {
  total.passed += counts.passed;
  total.failed += counts.failed;
  total.skipped += counts.skipped;
  total.flaky += counts.flaky ?? 0;
  process.stdout.write(`-- ${name}: ${counts.passed} passed, ${counts.failed} failed\n`);
}

function vitestCounts(text: string): Counts {
  const report: unknown = JSON.parse(text);
  // The groups around a failed test count as failed suites, too: it is one failure all the same. A file
  // that does not load fails without a test; `counted` sees that by the exit code.
  return {
    passed: numberAt(report, "numPassedTests"),
    failed: numberAt(report, "numFailedTests"),
    skipped: numberAt(report, "numPendingTests"),
  };
}

function playwrightCounts(text: string): Counts {
  const report: unknown = JSON.parse(text);
  const stats = typeof report === "object" && report !== null && "stats" in report && report.stats;
  const flaky = numberAt(stats, "flaky");
  return {
    passed: numberAt(stats, "expected") + flaky,
    failed: numberAt(stats, "unexpected"),
    skipped: numberAt(stats, "skipped"),
    flaky,
  };
}

/** The first element of a JUnit report carries the sums. */
function junitCounts(text: string): Counts {
  const sum = (name: string): number => Number(new RegExp(` ${name}="(\\d+)"`).exec(text)?.[1]);
  const failed = sum("failures") + sum("errors");
  const skipped = sum("skipped");
  const passed = sum("tests") - failed - skipped;
  if (Number.isNaN(passed)) throw new Error("the report has no sums");
  return { passed, failed, skipped };
}

function numberAt(from: unknown, key: string): number {
  const value =
    typeof from === "object" && from !== null
      ? Object.getOwnPropertyDescriptor(from, key)?.value
      : undefined;
  if (typeof value !== "number") throw new Error(`the report has no number ${key}`);
  return value;
}
