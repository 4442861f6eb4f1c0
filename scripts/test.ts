/**
 * `npm test`: types, lint, format, spelling, unused code, audit, unit tests, exhaustive tests,
 * integration tests, component tests, Python tests, build, end-to-end tests. Every stage runs even
 * if an earlier stage failed. The last line prints the totals.
 */
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { audit } from "./audit.ts";
import { requireChromium, tryInstallHeadlessShell } from "./chromium.ts";
import { tryInstallJava } from "./java.ts";
import { pythonTests, requirePython, requirePythonTools } from "./python.ts";
import { requireRedis } from "./redis-server.ts";
import {
  parseJunitReport,
  parsePlaywrightReport,
  parseVitestReport,
  type TestReport,
} from "./test-reports.ts";

/** Repeated at the end, because the output is long. */
const failures: string[] = [];
const folder = mkdtempSync(join(tmpdir(), "corridor-test-"));
type Counts = Omit<TestReport, "failures"> & Partial<TestReport>;

const total = { passed: 0, failed: 0, skipped: 0 };

const hasRequirements = [check("Python", requirePython), check("browser", requireChromium)].every(
  Boolean,
);
// Without Redis, the tests that need it are skipped. That must not count as success.
if (!check("Redis", requireRedis)) add("Redis", { passed: 0, failed: 1, skipped: 0 });
tryInstallHeadlessShell();
tryInstallJava();
stage("types", ["tsc", "-b"]);
stage("lint", ["oxlint", "--max-warnings", "0"]);
stage("format", ["oxfmt", "--check"]);
stage("spelling", ["cspell", "--no-progress", "--no-summary"]);
stage("unused code", ["knip"]);
auditStage();
vitestStage("unit");
vitestStage("exhaustive");
vitestStage("integration");
if (hasRequirements) vitestStage("components");
else add("components", { passed: 0, failed: 1, skipped: 0 });
if (check("Python test tools", requirePythonTools)) {
  testStage("python", [...pythonTests], parseJunitReport);
} else {
  add("python", { passed: 0, failed: 1, skipped: 0 });
}
const isBuilt = stage("build", ["npm", "run", "build"]);
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
if (failures.length > 0) process.stdout.write(`\nFailed:\n${failures.join("\n")}\n`);
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
  const counts: Counts = { passed: 0, failed: 0, skipped: 0 };
  if (verdict === "unknown") counts.skipped = 1;
  else counts[verdict] = 1;
  add("audit", counts);
}

/** Runs a test runner that writes a report to a file, and counts the tests in the report. */
function testStage(
  name: string,
  args: string[],
  parseReport: (report: string) => TestReport,
): void {
  const file = join(folder, `${name.replaceAll(" ", "-")}.report`);
  const code = run(name, args, {
    VITEST_JSON_REPORT: file,
    PLAYWRIGHT_JSON_OUTPUT_NAME: file,
    PYTEST_ADDOPTS: `--junitxml=${file}`,
  });
  let counts: TestReport;
  try {
    counts = parseReport(readFileSync(file, "utf8"));
  } catch {
    counts = { passed: 0, failed: 1, skipped: 0, failures: ["no report"] };
  }
  // A runner can fail outside any test: a file does not load, or a server does not start.
  if (code !== 0 && counts.failed === 0) counts.failed = 1;
  if (counts.passed === 0 && counts.failed === 0) counts.failed = 1;
  add(name, counts);
}

/** Runs the script of a project of vitest.config.ts. */
function vitestStage(project: string): void {
  const reporters = ["--reporter=default", "--reporter=json"];
  testStage(project, ["npm", "run", `test:${project}`, "--", ...reporters], parseVitestReport);
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
  if (counts.failed > 0) {
    failures.push(...(counts.failures ?? ["see above"]).map((each) => `${name}: ${each}`));
  }
  total.passed += counts.passed;
  total.failed += counts.failed;
  total.skipped += counts.skipped;
  process.stdout.write(`-- ${name}: ${counts.passed} passed, ${counts.failed} failed\n`);
}
