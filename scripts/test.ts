/**
 * `npm test`: types, lint, format, unused code, audit, unit tests, Python tests, build, end-to-end
 * tests. Every stage runs even if an earlier stage failed. The last line prints the totals.
 */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { audit } from "./audit.ts";
import { requireChromium } from "./chromium.ts";
import { tryInstallJava } from "./java.ts";
import { pythonTests, requirePython, requirePythonTools } from "./python.ts";
import { requireRedis } from "./redis-server.ts";

interface Counts {
  passed: number;
  failed: number;
  skipped: number;
  /** The number of passed tests that passed only on a retry. */
  flaky?: number;
}

const folder = mkdtempSync(join(tmpdir(), "corridor-test-"));
const total = { passed: 0, failed: 0, skipped: 0, flaky: 0 };

const hasRequirements = [check("Python", requirePython), check("browser", requireChromium)].every(
  Boolean,
);
// Without Redis, the tests that need it are skipped. That must not count as success.
if (!check("Redis", requireRedis)) add("Redis", { passed: 0, failed: 1, skipped: 0 });
tryInstallJava();
stage("types", ["tsc", "-b"]);
stage("lint", ["oxlint", "--max-warnings", "0"]);
stage("format", ["oxfmt", "--check"]);
stage("unused code", ["knip"]);
auditStage();
testStage("unit", ["vitest", "run", "--reporter=default", "--reporter=json"], parseVitestReport);
if (check("Python test tools", requirePythonTools)) {
  testStage("python", [...pythonTests], parseJunitReport);
} else {
  add("python", { passed: 0, failed: 1, skipped: 0 });
}
const isBuilt = stage("build", ["vite", "build", "apps/web"]);
if (hasRequirements && isBuilt) {
  const args = ["playwright", "test", "--config", "e2e/playwright.config.ts"];
  testStage("end to end", args, parsePlaywrightReport);
} else {
  add("end to end", { passed: 0, failed: 1, skipped: 0 });
}
rmSync(folder, { recursive: true });

if (total.skipped > 0) {
  process.stdout.write(
    `\n${total.skipped} skipped: this machine or its package registry lacks a requirement\n`,
  );
}
if (total.flaky > 0) {
  process.stdout.write(`\n${total.flaky} passed only on a retry: see "flaky" above\n`);
}
process.stdout.write(`\n${total.passed} passed, ${total.failed} failed\n`);
process.exitCode = total.failed > 0 ? 1 : 0;

/** Runs a stage that passes or fails as a whole. @returns whether it passed */
function stage(name: string, args: string[]): boolean {
  const passed = run(name, args, {}) === 0;
  add(name, { passed: passed ? 1 : 0, failed: passed ? 0 : 1, skipped: 0 });
  return passed;
}

/** Audits the dependencies. Counts as skipped if the registry offers no audit. */
function auditStage(): void {
  process.stdout.write("\n== audit: npm audit\n");
  const { verdict, message } = audit();
  process.stdout.write(`${message}\n`);
  const counts = { passed: 0, failed: 0, skipped: 0 };
  if (verdict === "unknown") counts.skipped = 1;
  else counts[verdict] = 1;
  add("audit", counts);
}

/** Runs a test runner that writes a report to a file, and counts the tests in the report. */
function testStage(name: string, args: string[], parseReport: (report: string) => Counts): void {
  const file = join(folder, `${name.replaceAll(" ", "-")}.report`);
  const code = run(name, args, {
    VITEST_JSON_REPORT: file,
    PLAYWRIGHT_JSON_OUTPUT_NAME: file,
    PYTEST_ADDOPTS: `--junitxml=${file}`,
  });
  let counts: Counts;
  try {
    counts = parseReport(readFileSync(file, "utf8"));
  } catch {
    counts = { passed: 0, failed: 1, skipped: 0 };
  }
  // A runner can fail outside any test: a file does not load, or a server does not start.
  if (code !== 0 && counts.failed === 0) counts.failed = 1;
  if (counts.passed === 0 && counts.failed === 0) counts.failed = 1;
  add(name, counts);
}

function run(name: string, [command = "", ...args]: string[], extra: NodeJS.ProcessEnv): number {
  process.stdout.write(`\n== ${name}: ${[command, ...args].join(" ")}\n`);
  const { status } = spawnSync(command, args, {
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

function parseVitestReport(text: string): Counts {
  const report: unknown = JSON.parse(text);
  // Failed suites are not counted: a suite fails with each failed test in it. A file that does not
  // load fails without a test; `testStage` detects that by the exit code.
  return {
    passed: numberAt(report, "numPassedTests"),
    failed: numberAt(report, "numFailedTests"),
    skipped: numberAt(report, "numPendingTests"),
  };
}

function parsePlaywrightReport(text: string): Counts {
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

/** Reads the totals from the first element of a JUnit report. */
function parseJunitReport(text: string): Counts {
  const sum = (name: string): number => Number(new RegExp(` ${name}="(\\d+)"`).exec(text)?.[1]);
  const failed = sum("failures") + sum("errors");
  const skipped = sum("skipped");
  const passed = sum("tests") - failed - skipped;
  if (Number.isNaN(passed)) throw new Error("The JUnit report has no totals.");
  return { passed, failed, skipped };
}

function numberAt(from: unknown, key: string): number {
  const value =
    typeof from === "object" && from !== null
      ? Object.getOwnPropertyDescriptor(from, key)?.value
      : undefined;
  if (typeof value !== "number") throw new Error(`The test report has no number "${key}".`);
  return value;
}
