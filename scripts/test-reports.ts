/** Reads the totals and the failed tests from the reports of the test runners. */

export interface TestReport {
  passed: number;
  failed: number;
  skipped: number;
  /** the titles of the failed tests, with their files */
  failures: string[];
}

/** @param text report of vitest's reporter "json" */
export function parseVitestReport(text: string): TestReport {
  const report: unknown = JSON.parse(text);
  const failures = listAt(report, "testResults").flatMap((file) => {
    const name = String(fieldOf(file, "name"));
    const failed = listAt(file, "assertionResults").filter((test) => isFailed(test));
    if (failed.length === 0 && isFailed(file)) return [`${name}: does not load`];
    return failed.map((test) => `${name}: ${String(fieldOf(test, "fullName"))}`);
  });
  // Failed suites are not counted: a suite fails with each failed test in it.
  return {
    passed: numberAt(report, "numPassedTests"),
    failed: numberAt(report, "numFailedTests"),
    skipped: numberAt(report, "numPendingTests"),
    failures,
  };
}

/** @param text report of playwright's reporter "json" */
export function parsePlaywrightReport(text: string): TestReport {
  const report: unknown = JSON.parse(text);
  const stats = fieldOf(report, "stats");
  return {
    passed: numberAt(stats, "expected"),
    failed: numberAt(stats, "unexpected"),
    skipped: numberAt(stats, "skipped"),
    failures: listAt(report, "suites").flatMap(failedSpecs),
  };
}

/** @param text JUnit report in XML, whose first element has the totals */
export function parseJunitReport(text: string): TestReport {
  const sum = (name: string): number => Number(new RegExp(` ${name}="(\\d+)"`).exec(text)?.[1]);
  const failed = sum("failures") + sum("errors");
  const skipped = sum("skipped");
  const passed = sum("tests") - failed - skipped;
  if (Number.isNaN(passed)) throw new Error("The JUnit report has no totals.");
  const cases = text.matchAll(
    /<testcase classname="([^"]*)" name="([^"]*)"[^>]*><(?:failure|error)/g,
  );
  return {
    passed,
    failed,
    skipped,
    failures: [...cases].map(([, file, name]) => `${file}: ${name}`),
  };
}

function failedSpecs(suite: unknown): string[] {
  const own = listAt(suite, "specs")
    .filter((spec) => fieldOf(spec, "ok") === false)
    .map((spec) => `${String(fieldOf(spec, "file"))}: ${String(fieldOf(spec, "title"))}`);
  return [...own, ...listAt(suite, "suites").flatMap(failedSpecs)];
}

function isFailed(result: unknown): boolean {
  return fieldOf(result, "status") === "failed";
}

function fieldOf(from: unknown, key: string): unknown {
  return typeof from === "object" && from !== null
    ? Object.getOwnPropertyDescriptor(from, key)?.value
    : undefined;
}

/** @returns an empty list if there is no list of this name */
function listAt(from: unknown, key: string): unknown[] {
  const value = fieldOf(from, key);
  return Array.isArray(value) ? value : [];
}

function numberAt(from: unknown, key: string): number {
  const value = fieldOf(from, key);
  if (typeof value !== "number") throw new Error(`The test report has no number "${key}".`);
  return value;
}
