/** Checks programs and hand-ins against the tasks of a lesson, on all cores. */
import { writeFileSync } from "node:fs";
import { countMazes, violationOf, type LessonDocument, type LessonTask } from "@corridor/challenge";
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
  const tasks = tasksOf(readLessonFrom(challenge), parsed);
  const handIns = await readAllPrograms(parsed);
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
async function readAllPrograms({ programs: files, handIns }: LessonArguments): Promise<HandIn[]> {
  const { programs } = readFiles({ mazes: [], programs: files });
  const fromFiles = programs.map((value, at): HandIn => ({
    name: files[at] ?? "",
    read: { ok: true, value },
  }));
  const fromLinks = handIns === null ? [] : await readHandIns(handIns);
  if (fromFiles.length + fromLinks.length === 0) {
    throw new InputError(["--handins: found no lines, expected links of programs"]);
  }
  return [...fromFiles, ...fromLinks];
}

/** Grades every program in every task. @returns the lines in the order of the programs */
async function gradeAll(
  tasks: readonly LessonTask[],
  handIns: readonly HandIn[],
  entry: URL,
): Promise<GradedLine[]> {
  const programs = handIns.flatMap(({ read }) => (read.ok ? [read.value] : []));
  const checks = tasks.map((task) => ({
    task,
    programs: programs.filter((program) => violationOf(task, program) === null),
  }));
  const outcomes = await runChecks({ checks }, entry);
  return handIns.flatMap(({ name, read }) => {
    if (!read.ok) return [unreadableLine(name, read.problems)];
    return tasks.map((task, at) => {
      const graded: Graded = { name, program: read.value, number: at + 1, task };
      const violation = violationOf(task, read.value);
      return violation === null
        ? checkedLine(graded, outcomes[at]?.get(read.value) ?? [])
        : violationLine(graded, violation);
    });
  });
}

async function runChecks(job: CheckJob, entry: URL) {
  const units = unitsOfChecks(job).count;
  const seconds = job.checks.reduce(
    (sum, { task, programs }) => sum + programs.length * countMazes(task) * task.checks.seconds,
    0,
  );
  const workers = startWorkers("checks", { units, seconds }, entry);
  try {
    return groupOutcomes(job, await runOnAllCores(workers, job, unitsOfChecks));
  } finally {
    await terminate(workers);
  }
}
