/** Formats the lines of `grade --challenge` as JSON or CSV. */
import { lessonColumns, lessonFields, type LessonRow } from "@corridor/challenge";
import { csvLines } from "@corridor/report";

/** The rows as JSON, then a summary. @returns the lines */
export function jsonLines(rows: readonly LessonRow[]): string[] {
  const summary = {
    lines: rows.length,
    passed: rows.filter(({ passed }) => passed).length,
    unreadable: rows.filter(({ code }) => code === "unreadable").length,
  };
  return [...rows, { summary }].map((each) => JSON.stringify(each));
}

/** Formats a CSV table with a header row. @returns its lines */
export function lessonTable(rows: readonly LessonRow[]): string[] {
  return csvLines(lessonColumns, rows.map(lessonFields));
}
