/**
 * `npm test`: Python tests beside types, spelling and the build; lint, format, unused code, audit,
 * unit tests, exhaustive tests, integration tests, component tests, end-to-end tests. Every stage
 * runs even if an earlier stage failed. The last line prints the totals.
 */
import { spawn } from "node:child_process";
import { once } from "node:events";
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
type Output = "inherit" | "pipe";
type Counts = Omit<TestReport, "failures"> & Partial<TestReport>;

const total = { passed: 0, failed: 0, skipped: 0 };

const hasRequirements = [check("Python", requirePython), check("browser", requireChromium)].every(
  Boolean,
);
// Without Redis, the tests that need it are skipped. That must not count as success.
if (!check("Redis", requireRedis)) add("Redis", { passed: 0, failed: 1, skipped: 0 });
tryInstallHeadlessShell();
tryInstallJava();
// The Python tests use less than one core, and the stages beside them do not depend on time. Some of the
// tests need a relay that restarts within seconds, so they do not run beside the integration tests.
const python = check("Python test tools", requirePythonTools)
  ? testStage("python", [...pythonTests], parseJunitReport, "pipe")
  : null;
if (python === null) add("python", { passed: 0, failed: 1, skipped: 0 });
await stage("types", ["npm", "run", "--silent", "typecheck"]);
await stage("spelling", ["cspell", "--no-progress", "--no-summary"]);
const isBuilt = await stage("build", ["npm", "run", "build"]);
await python;
await stage("lint", ["oxlint", "--max-warnings", "0"]);
await stage("format", ["oxfmt", "--check"]);
await stage("unused code", ["knip"]);
auditStage();
await vitestStage("unit");
await vitestStage("exhaustive");
await vitestStage("integration");
if (hasRequirements) await vitestStage("components");
else add("components", { passed: 0, failed: 1, skipped: 0 });
if (hasRequirements && isBuilt) {
  const args = ["playwright", "test", "--config", "e2e/playwright.config.ts"];
  await testStage("end to end", args, parsePlaywrightReport);
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
async function stage(name: string, args: string[]): Promise<boolean> {
  const passed = (await run(name, args, {})) === 0;
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

/**
 * Runs a test runner that writes a report to a file, and counts the tests in the report.
 * @param output "pipe" prints the output at the end, because another stage prints meanwhile
 */
async function testStage(
  name: string,
  args: string[],
  parseReport: (report: string) => TestReport,
  output: Output = "inherit",
): Promise<void> {
  const file = join(folder, `${name.replaceAll(" ", "-")}.report`);
  const reports = {
    VITEST_JSON_REPORT: file,
    PLAYWRIGHT_JSON_OUTPUT_NAME: file,
    PYTEST_ADDOPTS: `--junitxml=${file}`,
  };
  const code = await run(name, args, reports, output);
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
async function vitestStage(project: string): Promise<void> {
  const reporters = ["--reporter=default", "--reporter=json"];
  await testStage(
    project,
    ["npm", "run", `test:${project}`, "--", ...reporters],
    parseVitestReport,
  );
}

/** @returns the exit code of the command */
async function run(
  name: string,
  [command = "", ...args]: string[],
  extra: NodeJS.ProcessEnv,
  output: Output = "inherit",
): Promise<number> {
  const title = `\n== ${name}: ${[command, ...args].join(" ")}\n`;
  if (output === "inherit") process.stdout.write(title);
  const child = spawn(command, args, {
    stdio: ["ignore", output, output],
    env: { ...process.env, ...extra },
    shell: process.platform === "win32",
  });
  const printed: Buffer[] = [];
  for (const stream of [child.stdout, child.stderr]) {
    stream?.on("data", (chunk: Buffer) => printed.push(chunk));
  }
  // "close" follows the end of the output; a command that does not exist emits "error".
  const [code] = await once(child, "close").catch(() => [1]);
  if (output === "pipe") process.stdout.write(`${title}${Buffer.concat(printed).toString()}`);
  return typeof code === "number" ? code : 1;
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
