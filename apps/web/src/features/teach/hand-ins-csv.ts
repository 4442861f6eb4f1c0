/** The table of hand-ins as CSV: the columns of `grade --csv`, and identical programs. */
import { lessonColumns, lessonFields, unreadableRow, type LessonRow } from "@corridor/challenge";
import { csvLines } from "@corridor/report";
import type { HandInRow } from "./check-hand-ins.ts";

/** Leaves out rows that are not checked in every maze. */
export function handInsCsv(rows: readonly HandInRow[]): string {
  const fields = rows.flatMap((each) => {
    const row = finalRow(each);
    return row === null ? [] : [[each.number, ...lessonFields(row), each.sameAs ?? ""]];
  });
  const lines = csvLines(["number", ...lessonColumns, "sameAs"], fields);
  // Spreadsheets expect a byte order mark in UTF-8.
  return `\uFEFF${lines.join("\r\n")}\r\n`;
}

function finalRow({ source, checked }: HandInRow): LessonRow | null {
  const name = "file" in source ? source.file : `line ${source.line}`;
  if (!checked.ok) return unreadableRow(name, checked.problem);
  return checked.row && { ...checked.row, program: name };
}
