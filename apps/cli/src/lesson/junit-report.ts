/**
 * Formats the lines of `grade --challenge` as a JUnit report, which build servers display: one test
 * case for each program and task.
 */
import type { GradedLine } from "./lesson-lines.ts";

/** @returns the report, XML 1.0 in UTF-8 */
export function junitReport(lines: readonly GradedLine[]): string {
  const failures = lines.filter(({ row }) => !row.passed).length;
  return [
    '<?xml version="1.0" encoding="UTF-8"?>',
    "<testsuites>",
    `  <testsuite name="corridor grade" tests="${lines.length}" failures="${failures}" errors="0" skipped="0">`,
    ...lines.map(testCase),
    "  </testsuite>",
    "</testsuites>",
    "",
  ].join("\n");
}

function testCase({ row, message }: GradedLine): string {
  const name = row.task === null ? "hand-in" : `task ${row.task}`;
  const opening = `    <testcase classname=${quoted(row.program)} name="${name}"`;
  if (message === null) return `${opening}/>`;
  const place = row.maze === null ? "" : `${row.maze}, tick ${row.tick}`;
  const failure = `<failure type="${row.code}" message=${quoted(message)}>${escaped(place)}</failure>`;
  return `${opening}>${failure}</testcase>`;
}

function quoted(text: string): string {
  return `"${escaped(text)}"`;
}

const entities: Record<string, string> = {
  "&": "&amp;",
  "<": "&lt;",
  ">": "&gt;",
  '"': "&quot;",
  // An attribute would replace these by spaces.
  "\t": "&#9;",
  "\n": "&#10;",
  "\r": "&#13;",
};

/** What XML 1.0 forbids, even as a reference: most control characters and lone surrogates. */
const FORBIDDEN = /[^\t\n\r\u0020-\uD7FF\uE000-\uFFFD\u{10000}-\u{10FFFF}]/gu;

function escaped(text: string): string {
  return text
    .replaceAll(FORBIDDEN, "\uFFFD")
    .replaceAll(/[&<>"\t\n\r]/g, (character) => entities[character] ?? character);
}
