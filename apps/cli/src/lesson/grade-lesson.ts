/** Checks programs and hand-ins against the tasks of a lesson, on all cores. */
import { writeFileSync } from "node:fs";
import {
  countMazes,
  violationOf,
  type Attempt,
  type LessonDocument,
  type LessonTask,
} from "@corridor/challenge";
import { runOnAllCores, startWorkers, terminate } from "../all-cores.ts";
import type { GradeOptions } from "../arguments.ts";
import { InputError } from "../input-error.ts";
import { readFiles, reasonOf } from "../read-files.ts";
import { groupOutcomes, unitsOfChecks, type CheckJob } from "./check-units.ts";
import { junitReport } from "./junit-report.ts";
import { lessonArguments, type LessonArguments } from "./lesson-arguments.ts";
import { jsonLines, lessonTable } from "./lesson-report.ts";
import {
  checkedLine,
  unreadableLine,
  violationLine,
  type Graded,
  type GradedLine,
  type LessonRow,
} from "./lesson-rows.ts";
import { readHandIns, type HandIn } from "./read-hand-ins.ts";
import { readLessonFrom } from "./read-lesson.ts";

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

/** Reads the program files, then the hand-ins. */
async function readAllHandIns(
  { programs: files, handIns }: LessonArguments,
  lesson: LessonDocument,
): Promise<HandIn[]> {
  const { programs } = readFiles({ mazes: [], programs: files });
  const fromFiles = programs.map((attempt, at): HandIn => ({
    name: files[at] ?? "",
    read: { ok: true, attempt, task: null },
  }));
  const fromLines = handIns === null ? [] : await readHandIns(handIns, lesson);
  if (fromFiles.length + fromLines.length === 0) {
    throw new InputError(["--handins: found no lines, expected links or completion codes"]);
  }
  return [...fromFiles, ...fromLines];
}

/** Grades every hand-in in each of its tasks. @returns the lines in the order of the hand-ins */
async function gradeAll(
  tasks: readonly LessonTask[],
  handIns: readonly HandIn[],
  entry: URL,
): Promise<GradedLine[]> {
  const checks = tasks.map((task, at) => ({ task, attempts: attemptsAt(at, task, handIns) }));
  const outcomes = await runChecks({ checks }, entry);
  return handIns.flatMap(({ name, read }) => {
    if (!read.ok) return [unreadableLine(name, read.problem)];
    const { attempt } = read;
    return tasks.flatMap((task, at) => {
      if (!isFor(at, read)) return [];
      const graded: Graded = { name, attempt, number: at + 1, task };
      const violation = violationOf(task, attempt);
      return violation === null
        ? checkedLine(graded, outcomes[at]?.get(attempt) ?? [])
        : violationLine(graded, violation);
    });
  });
}

/** The attempts to run in a task. @param index of the task */
function attemptsAt(index: number, task: LessonTask, handIns: readonly HandIn[]): Attempt[] {
  return handIns.flatMap(({ read }) =>
    read.ok && isFor(index, read) && violationOf(task, read.attempt) === null ? [read.attempt] : [],
  );
}

function isFor(index: number, { task }: { task: number | null }): boolean {
  return task === null || task === index;
}

async function runChecks(job: CheckJob, entry: URL) {
  const units = unitsOfChecks(job).count;
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
