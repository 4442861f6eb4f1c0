/** The report of a class as CSV. In a file of its own, with the package for reports. */
import { studyCsv } from "@corridor/report";
import { studyOf, type ClassStudyParts } from "../../model/classroom/class-study.ts";

export function reportCsv(parts: ClassStudyParts): string {
  // Spreadsheets expect a byte order mark in UTF-8.
  return `\uFEFF${studyCsv(studyOf(parts)).join("\r\n")}\r\n`;
}
