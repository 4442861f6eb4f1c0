/** Checks programs and hand-ins against the tasks of a lesson, on all cores. */
import { writeFileSync } from "node:fs";
import {
  checkedRow,
  countCheckUnits,
  countMazes,
  violationOf,
  violationRow,
  type Attempt,
  type CheckJob,
  type Graded,
  type LessonDocument,
  type LessonRow,
  type LessonTask,
} from "@corridor/challenge";
import type { HandIn, HandInResult } from "@corridor/link";
import { runOnAllCores, startWorkers, terminate } from "../all-cores.ts";
import type { GradeOptions } from "../arguments.ts";
import { InputError } from "../input-error.ts";
import { reasonOf } from "../read-files.ts";
import { groupOutcomes, unitsOfChecks } from "./check-units.ts";
import { junitReport } from "./junit-report.ts";
import { lessonArguments, type LessonArguments } from "./lesson-arguments.ts";
import { gradedLine, unreadableLine, type GradedLine } from "./lesson-lines.ts";
import { jsonLines, lessonTable } from "./lesson-report.ts";
import { readHandInFiles, readHandIns } from "./read-hand-ins.ts";
import { readLessonFrom } from "./read-lesson.ts";

interface NamedHandIn {
  /** file, or the line of the hand-in such as "line 3" */
  name: string;
  read: HandInResult;
}

export interface LessonGrading {
  /** lines to print */
  lines: string[];
  /** whether enough lines pass for `--require` */
  isMet: boolean;
}

/** @throws InputError if the arguments, the lesson or the files are invalid */
export async function gradeLesson(
  challenge: string,
  options: GradeOptions,
  entry: URL,
): Promise<LessonGrading> {
  const parsed = lessonArguments(challenge, options);
  const lesson = readLessonFrom(challenge);
  const tasks = tasksOf(lesson, parsed);
  const handIns = await readAllHandIns(parsed, lesson);
  const graded = await gradeAll(tasks, handIns, entry);
  if (parsed.junit !== null) writeReport(parsed.junit, junitReport(graded));
  const rows = graded.map(({ row }) => row);
  return {
    lines: parsed.csv ? lessonTable(rows) : jsonLines(rows),
    isMet: isMet(rows, parsed.required),
  };
}

function writeReport(file: string, text: string): void {
  try {
    writeFileSync(file, text);
  } catch (error) {
    throw new InputError([
      `${file}: found ${reasonOf(error)}, expected a writable file in an existing folder`,
    ]);
  }
}

/** @param required share of the rows that must pass, in per cent; null for none */
export function isMet(rows: readonly LessonRow[], required: number | null): boolean {
  const passed = rows.filter((row) => row.passed).length;
  return required === null || passed * 100 >= required * rows.length;
}

function tasksOf({ tasks }: LessonDocument, { unseen }: LessonArguments): LessonTask[] {
  return unseen === null ? tasks : tasks.map((task) => ({ ...task, unseen }));
}

/** Reads the files of programs and runs, then the lines of the hand-ins. */
async function readAllHandIns(
  { programs: files, handIns }: LessonArguments,
  lesson: LessonDocument,
): Promise<NamedHandIn[]> {
  const fromFiles = readHandInFiles(files).map(({ name, value }): NamedHandIn => ({
    name,
    read: { ok: true, value },
  }));
  const lines = handIns === null ? [] : await readHandIns(handIns, lesson);
  const fromLines = lines.map(({ line, read }): NamedHandIn => ({ name: `line ${line}`, read }));
  if (fromFiles.length + fromLines.length === 0) {
    throw new InputError(["--handins: found no lines, expected links or completion codes"]);
  }
  return [...fromFiles, ...fromLines];
}

/** Grades every hand-in in each of its tasks. @returns the lines in the order of the hand-ins */
async function gradeAll(
  tasks: readonly LessonTask[],
  handIns: readonly NamedHandIn[],
  entry: URL,
): Promise<GradedLine[]> {
  const checks = tasks.map((task, at) => ({ task, attempts: attemptsAt(at, task, handIns) }));
  const outcomes = await runChecks({ checks }, entry);
  return handIns.flatMap(({ name, read }) => {
    if (!read.ok) return [unreadableLine(name, read.problem)];
    const { attempt } = read.value;
    return tasks.flatMap((task, at) => {
      if (!isFor(at, read.value)) return [];
      const graded: Graded = { name, attempt, number: at + 1, task };
      const violation = violationOf(task, attempt);
      const row =
        violation === null
          ? checkedRow(graded, outcomes[at]?.get(attempt) ?? [])
          : violationRow(graded, violation);
      return gradedLine(row, graded);
    });
  });
}

/** The attempts to run in a task. @param index of the task */
function attemptsAt(index: number, task: LessonTask, handIns: readonly NamedHandIn[]): Attempt[] {
  return handIns.flatMap(({ read }) => {
    if (!read.ok || !isFor(index, read.value)) return [];
    return violationOf(task, read.value.attempt) === null ? [read.value.attempt] : [];
  });
}

function isFor(index: number, { task }: HandIn): boolean {
  return task === null || task === index;
}

async function runChecks(job: CheckJob, entry: URL) {
  const units = countCheckUnits(job);
  const seconds = job.checks.reduce(
    (sum, { task, attempts }) => sum + attempts.length * countMazes(task) * task.checks.seconds,
    0,
  );
  const workers = startWorkers("checks", { units, seconds }, entry);
  try {
    return groupOutcomes(job, await runOnAllCores(workers, job, unitsOfChecks));
  } finally {
    await terminate(workers);
  }
}
