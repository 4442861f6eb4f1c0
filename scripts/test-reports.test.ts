import { describe, expect, it } from "vitest";
import { parseJunitReport, parsePlaywrightReport, parseVitestReport } from "./test-reports.ts";

describe("the totals at the end of the tests name each failed test", () => {
  it("of vitest, and each file that does not load", () => {
    const report = {
      numPassedTests: 2,
      numFailedTests: 1,
      numPendingTests: 0,
      testResults: [
        {
          name: "a.test.ts",
          status: "failed",
          assertionResults: [
            { status: "failed", fullName: "a robot stops" },
            { status: "passed", fullName: "a robot turns" },
          ],
        },
        { name: "b.test.ts", status: "failed", assertionResults: [] },
        { name: "c.test.ts", status: "passed", assertionResults: [] },
      ],
    };
    expect(parseVitestReport(JSON.stringify(report))).toEqual({
      passed: 2,
      failed: 1,
      skipped: 0,
      failures: ["a.test.ts: a robot stops", "b.test.ts: does not load"],
    });
  });

  it("of playwright, in suites of suites", () => {
    const specs = [
      { ok: false, file: "a.spec.ts", title: "drives" },
      { ok: true, file: "a.spec.ts", title: "turns" },
    ];
    const report = {
      stats: { expected: 3, unexpected: 1, skipped: 2 },
      suites: [{ specs: [], suites: [{ specs }] }],
    };
    expect(parsePlaywrightReport(JSON.stringify(report))).toEqual({
      passed: 3,
      failed: 1,
      skipped: 2,
      failures: ["a.spec.ts: drives"],
    });
  });

  it("of JUnit", () => {
    const report = `<testsuites><testsuite errors="0" failures="1" skipped="1" tests="4">
      <testcase classname="tests.robot" name="test_stop" time="1"><failure message="no"/></testcase>
      <testcase classname="tests.robot" name="test_turn" time="1" /></testsuite></testsuites>`;
    expect(parseJunitReport(report)).toEqual({
      passed: 2,
      failed: 1,
      skipped: 1,
      failures: ["tests.robot: test_stop"],
    });
  });
});
