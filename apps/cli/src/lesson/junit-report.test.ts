import type { LessonRow } from "@corridor/challenge";
import { describe, expect, it } from "vitest";
import { junitReport } from "./junit-report.ts";
import type { GradedLine } from "./lesson-lines.ts";

const passed: LessonRow = {
  program: "a.json",
  task: 1,
  passed: true,
  code: null,
  maze: null,
  tick: null,
  lines: 2,
  seconds: 8,
  unseen: null,
};
const bump: LessonRow = { ...passed, passed: false, code: "bump", maze: "maze 2", tick: 255 };
const failed: GradedLine = { row: bump, message: "1 bump, at most 0 are allowed" };

function caseOf(program: string, message: string): string {
  const report = junitReport([{ row: { ...bump, program }, message }]);
  return report.split("\n").find((line) => line.includes("<testcase")) ?? "";
}

describe("a JUnit report", () => {
  it("has a test case for each program and task", () => {
    expect(junitReport([{ row: passed, message: null }, failed])).toBe(
      `<?xml version="1.0" encoding="UTF-8"?>
<testsuites>
  <testsuite name="corridor grade" tests="2" failures="1" errors="0" skipped="0">
    <testcase classname="a.json" name="task 1"/>
    <testcase classname="a.json" name="task 1"><failure type="bump" message="1 bump, at most 0 are allowed">maze 2, tick 255</failure></testcase>
  </testsuite>
</testsuites>
`,
    );
  });

  it("has a test case for an unreadable hand-in", () => {
    const row: LessonRow = {
      ...bump,
      program: "line 3",
      task: null,
      code: "unreadable",
      maze: null,
    };
    expect(junitReport([{ row, message: "no link" }])).toContain(
      '<testcase classname="line 3" name="hand-in"><failure type="unreadable" message="no link"></failure></testcase>',
    );
  });

  it.each([
    ["markup", `<a href="x">&amp;'`, "&lt;a href=&quot;x&quot;&gt;&amp;amp;'"],
    ["line ends and tabs", "a\nb\r\tc", "a&#10;b&#13;&#9;c"],
    ["control characters", "a\u0000\u0007\u001Bb", "a\uFFFD\uFFFD\uFFFDb"],
    ["half a surrogate pair", "a\uD83Db\uDE00", "a\uFFFDb\uFFFD"],
    ["characters that XML forbids", "a\uFFFE\uFFFFb", "a\uFFFD\uFFFDb"],
    ["other languages and emoji", "né 迷路 🤖", "né 迷路 🤖"],
  ])("escapes %s", (_, text, escaped) => {
    expect(caseOf(text, text)).toContain(`classname="${escaped}"`);
    expect(caseOf(text, text)).toContain(`message="${escaped}"`);
  });
});
