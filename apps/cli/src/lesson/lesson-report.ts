/** Formats the lines of `grade --challenge` as JSON or CSV. */
import { csvLines } from "@corridor/report";
import type { LessonRow } from "./lesson-rows.ts";

/** The rows as JSON, then a summary. @returns the lines */
export function jsonLines(rows: readonly LessonRow[]): string[] {
  const summary = {
    lines: rows.length,
    passed: rows.filter(({ passed }) => passed).length,
    unreadable: rows.filter(({ code }) => code === "unreadable").length,
  };
  return [...rows, { summary }].map((each) => JSON.stringify(each));
}

const csvColumns = [
  "program",
  "task",
  "passed",
  "code",
  "maze",
  "tick",
  "lines",
  "seconds",
  "unseenCount",
  "unseenPassed",
  "unseenFailed",
  "problem",
] as const;

/** Formats a CSV table with a header row. @returns its lines */
export function lessonTable(rows: readonly LessonRow[]): string[] {
  const table = rows.map((row) => [
    row.program,
    row.task ?? "",
    row.passed,
    row.code ?? "",
    row.maze ?? "",
    row.tick ?? "",
    row.lines ?? "",
    row.seconds ?? "",
    row.unseen?.count ?? "",
    row.unseen?.passed ?? "",
    row.unseen?.failed.join(" ") ?? "",
    row.problem ?? "",
  ]);
  return csvLines(csvColumns, table);
}
