/**
 * Studies as CSV. A row is the work of one student on one task, or, without a task, a student's
 * answers, which may all be empty. The columns of the answers are the ids of the questions, with
 * `answer_` before an id that is the name of another column.
 *
 * Two tables of the thesis of 2013 are read as well: times, with one column `TASK_seconds` per task
 * and one row per student, and answers, with one column per question.
 */
import { problem, readValue, type FieldProblem, type ReadResult } from "@corridor/protocol";
import { csvLines, parseCsv, type CsvTable, type CsvValue } from "./csv.ts";
import { questionIds } from "./report.ts";
import {
  answersSchema,
  answerTo,
  workSchema,
  type Answers,
  type Study,
  type Work,
} from "./study.ts";

/** 200 students with 12 tasks and a survey have 2,600 rows. */
export const MAX_ROWS = 10_000;
export const MAX_CSV_LENGTH = 2 * 1024 * 1024;
const MAX_PROBLEMS = 20;

const SECONDS = "_seconds";
const QUESTION_ID = /^[a-z][a-z0-9_]{0,31}$/;
const FORMS =
  "columns student and task, columns that end with _seconds, or columns of questions such as navigation";

/** The counts of a row, by their columns. */
const counts = {
  seconds: "seconds",
  lines: "lines",
  attempts: "attempts",
  runs: "runs",
  bumps: "bumps",
  failed_checks: "failedChecks",
  hints: "hints",
  mistakes: "mistakes",
} as const satisfies Record<string, keyof Work>;
const countColumns = Object.entries(counts);

const ANSWER = "answer_";

/** Whether an id needs the prefix: it is the name of a column, or such a name with the prefix. */
function needsPrefix(id: string): boolean {
  const name = id.replace(/^(?:answer_)+/, "");
  return name === "student" || name === "task" || Object.hasOwn(counts, name);
}

/** The column of the answers to a question. */
function answerColumn(id: string): string {
  return needsPrefix(id) ? ANSWER + id : id;
}

/** The id of the question whose answers a column contains. */
function idOfColumn(column: string): string {
  const id = column.startsWith(ANSWER) ? column.slice(ANSWER.length) : column;
  return needsPrefix(id) ? id : column;
}

/** Formats a study. @returns the lines of the table */
export function studyCsv(study: Study): string[] {
  const ids = questionIds(study);
  const columns = [
    "student",
    "task",
    ...countColumns.map(([column]) => column),
    ...ids.map(answerColumn),
  ];
  const work = study.work.map((row) => [
    row.student,
    row.task,
    ...countColumns.map(([, field]) => row[field]),
    ...ids.map(() => null),
  ]);
  const survey = study.survey.map((row): CsvValue[] => [
    row.student,
    null,
    ...countColumns.map(() => null),
    ...ids.map((id) => answerTo(row, id)),
  ]);
  return csvLines(columns, [...work, ...survey]);
}

/** Reads a table of one of the three forms. */
export function readStudyCsv(text: string): ReadResult<Study> {
  if (text.length > MAX_CSV_LENGTH) {
    return problem("", `${text.length} characters`, `at most ${MAX_CSV_LENGTH} characters`);
  }
  const table = parseCsv(text, MAX_ROWS + 1);
  if (table === null) return problem("", "text that is not CSV", "a CSV table with a header row");
  const { columns, rows } = table;
  if (rows.length > MAX_ROWS) {
    return problem("", `more than ${MAX_ROWS} rows`, `at most ${MAX_ROWS} rows`);
  }
  const repeated = columns.find((column, index) => columns.indexOf(column) !== index);
  if (repeated !== undefined) {
    return problem("row 1", `two columns ${JSON.stringify(repeated)}`, "one column of each name");
  }
  if (columns.includes("student") && columns.includes("task")) return readRows(table);
  if (columns.every((column) => column.endsWith(SECONDS) && column.length > SECONDS.length)) {
    return readTimes(table);
  }
  if (columns.every((column) => QUESTION_ID.test(column))) return readAnswers(table);
  return problem("row 1", `the columns ${columns.join(", ").slice(0, 100)}`, FORMS);
}

/** Combines studies, such as times and answers from two files. */
export function joinStudies(studies: readonly Study[]): ReadResult<Study> {
  const study = {
    work: studies.flatMap(({ work }) => work),
    survey: studies.flatMap(({ survey }) => survey),
  };
  const seen = new Set<string>();
  for (const { student, task } of study.work) {
    const key = JSON.stringify([student, task]);
    if (student !== null && seen.has(key)) {
      return problem("", `two rows of ${student} and ${task}`, "one row per student and task");
    }
    seen.add(key);
  }
  return { ok: true, value: study };
}

function readRows({ columns, rows }: CsvTable): ReadResult<Study> {
  const isKnown = (column: string) =>
    column === "student" || column === "task" || Object.hasOwn(counts, column);
  const ids = columns.filter((column) => !isKnown(column)).map(idOfColumn);
  const wrong = ids.find((id) => !QUESTION_ID.test(id));
  if (wrong !== undefined) {
    return problem("row 1", `the column ${JSON.stringify(wrong)}`, "the id of a question");
  }
  const work: Work[] = [];
  const survey: Answers[] = [];
  const problems: FieldProblem[] = [];
  for (const { at, cells } of rows) {
    const cell = (column: string): string => cells[columns.indexOf(column)] ?? "";
    const student = cell("student") || null;
    const answers = Object.fromEntries(ids.map((id) => [id, numberOf(cell(answerColumn(id)))]));
    const isSurvey = cell("task") === "";
    if (isSurvey) {
      take(readValue(answersSchema, { student, answers }), at, survey, problems, answerColumn);
    } else if (Object.values(answers).some((answer) => answer !== null)) {
      problems.push({
        path: `row ${at}, task`,
        found: JSON.stringify(cell("task")),
        expected: "no task in a row with answers",
      });
    } else {
      const fields = countColumns.map(([column, field]) => [field, numberOf(cell(column))]);
      const row = { student, task: cell("task"), ...Object.fromEntries(fields) };
      take(readValue(workSchema, row), at, work, problems);
    }
  }
  return resultOf({ work, survey }, problems);
}

function readTimes({ columns, rows }: CsvTable): ReadResult<Study> {
  const work: Work[] = [];
  const problems: FieldProblem[] = [];
  const unknown = Object.fromEntries(Object.values(counts).map((field) => [field, null]));
  for (const [index, column] of columns.entries()) {
    for (const { at, cells } of rows) {
      const seconds = numberOf(cells[index] ?? "");
      const row = { ...unknown, student: null, task: column.slice(0, -SECONDS.length), seconds };
      take(readValue(workSchema, row), at, work, problems, () => column);
    }
  }
  return resultOf({ work, survey: [] }, problems);
}

function readAnswers({ columns, rows }: CsvTable): ReadResult<Study> {
  const survey: Answers[] = [];
  const problems: FieldProblem[] = [];
  for (const { at, cells } of rows) {
    const entries = columns.map((id, index) => [id, numberOf(cells[index] ?? "")]);
    const row = { student: null, answers: Object.fromEntries(entries) };
    take(readValue(answersSchema, row), at, survey, problems);
  }
  return resultOf({ work: [], survey }, problems);
}

/**
 * Adds a row, or its problems with their place in the table.
 * @param columnOf the column of a field or of the answers to a question
 */
function take<Row>(
  read: ReadResult<Row>,
  at: number,
  rows: Row[],
  problems: FieldProblem[],
  columnOf = countColumn,
): void {
  if (read.ok) rows.push(read.value);
  else {
    for (const each of read.problems) {
      problems.push({
        ...each,
        path: `row ${at}, ${columnOf(each.path.replace(/^answers\./, ""))}`,
      });
    }
  }
}

function countColumn(field: string): string {
  return countColumns.find(([, name]) => name === field)?.[0] ?? field;
}

function resultOf(study: Study, problems: readonly FieldProblem[]): ReadResult<Study> {
  return problems.length === 0
    ? { ok: true, value: study }
    : { ok: false, problems: problems.slice(0, MAX_PROBLEMS) };
}

/** A number, null for an empty cell, or the text of the cell, which a schema then reports. */
function numberOf(cell: string): number | string | null {
  if (cell === "") return null;
  // Spreadsheets of many languages write a decimal comma.
  return /^\d{1,9}(?:[.,]\d{1,9})?$/.test(cell) ? Number(cell.replace(",", ".")) : cell;
}
