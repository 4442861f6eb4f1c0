/** Reads the tables that a teacher opens for a report. */
import { joinStudies, readStudyCsv, type Study } from "@corridor/report";
import type { FieldProblem } from "@corridor/protocol";
import { reportName, type SavedReport } from "../../../model/teaching/saved-reports.ts";
import { datedFileName } from "../../../ui/dated-file-name.ts";
import type { TextFile } from "../../../ui/incoming-files.ts";

/** A table of 10,000 rows is smaller. */
const MAX_FILE_BYTES = 8 * 1024 * 1024;

export interface ReportFile {
  name: string;
  study: Study;
  /** of a report of this device; undefined: a file */
  saved?: Pick<SavedReport, "savedAt" | "code">;
}

export type ReportProblem = { file: string } & (
  | { code: "size" | "unreadable" }
  | { code: "table"; problem: FieldProblem }
);

export interface ReadFiles {
  files: ReportFile[];
  problems: ReportProblem[];
}

/** A report of this device as an open table; null if it cannot be read. */
export function openReport(saved: SavedReport): ReportFile | null {
  const read = readStudyCsv(saved.csv);
  return read.ok ? { name: reportName(saved), study: read.value, saved } : null;
}

/** The name of the file in which the open tables are saved as one. */
export function savedFileName(files: readonly ReportFile[]): string {
  const [file, ...others] = files;
  if (file === undefined || others.length > 0) return "report.csv";
  if (file.saved === undefined) return file.name;
  return `${datedFileName(file.name, file.saved.savedAt, "report")}.csv`;
}

/**
 * Reads files and adds them to those that are open. A file with the name of an open one replaces
 * it. An invalid file changes nothing.
 */
export async function addReportFiles(
  open: readonly ReportFile[],
  added: readonly TextFile[],
): Promise<ReadFiles> {
  let files = [...open];
  const problems: ReportProblem[] = [];
  for (const each of added) {
    const read = await readReportFile(each);
    if ("code" in read) {
      problems.push(read);
      continue;
    }
    const next = [...files.filter(({ name }) => name !== read.name), read];
    const joined = joinStudies(next.map(({ study }) => study));
    if (joined.ok) files = next;
    else problems.push(...tableProblems(each.name, joined.problems));
  }
  return { files, problems };
}

/** All open tables as one study. */
export function studyOf(files: readonly ReportFile[]): Study {
  const joined = joinStudies(files.map(({ study }) => study));
  return joined.ok ? joined.value : { work: [], survey: [] };
}

async function readReportFile(file: TextFile): Promise<ReportFile | ReportProblem> {
  if (file.size > MAX_FILE_BYTES) return { file: file.name, code: "size" };
  let text: string;
  try {
    text = await file.text();
  } catch {
    return { file: file.name, code: "unreadable" };
  }
  const read = readStudyCsv(text);
  if (read.ok) return { name: file.name, study: read.value };
  const [first] = tableProblems(file.name, read.problems);
  return first ?? { file: file.name, code: "unreadable" };
}

/** The first problem: the others often follow from it. */
function tableProblems(file: string, problems: readonly FieldProblem[]): ReportProblem[] {
  return problems.slice(0, 1).map((problem) => ({ file, code: "table", problem }));
}
