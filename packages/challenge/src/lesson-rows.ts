/** The rows of a table of graded attempts: one for each attempt and task. */
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { isProgram, type Attempt } from "./check-challenge.ts";
import { taskVerdict } from "./check-task.ts";
import type { LessonTask } from "./lesson-document.ts";
import { unseenName } from "./unseen-mazes.ts";
import type { Failure, FailureCode, MazeOutcome } from "./verdict.ts";

export interface LessonRow {
  /** file, or the line of the hand-in such as "line 3" */
  program: string;
  /** from 1; null for an unreadable hand-in */
  task: number | null;
  passed: boolean;
  /** null if the attempt passes */
  code: FailureCode | "unreadable" | null;
  /** name of the maze of the first failure; null if none was run */
  maze: string | null;
  /** tick of the first failure */
  tick: number | null;
  /** number of lines of the program, without "otherwise"; null for a drive */
  lines: number | null;
  /** simulated time in the slowest given maze; null unless the attempt passes in all of them */
  seconds: number | null;
  /** null if no unseen mazes were run */
  unseen: { count: number; passed: number; failed: number[] } | null;
  /** set for an unreadable hand-in only */
  problem?: string;
}

/** A row, with the failure that it describes. */
export interface GradedRow {
  row: LessonRow;
  /** null if the attempt passes */
  failure: Failure | null;
}

export interface Graded {
  name: string;
  attempt: Attempt;
  /** number of the task, from 1 */
  number: number;
  task: LessonTask;
}

/** The row of an attempt that the task does not allow. */
export function violationRow(graded: Graded, violation: Failure): GradedRow {
  return rowOf(graded, violation, { maze: null, seconds: null, unseen: null });
}

/** The row of an attempt that ran. @param outcomes of all mazes of the task */
export function checkedRow(graded: Graded, outcomes: readonly MazeOutcome[]): GradedRow {
  const { mazes, unseen } = graded.task;
  const { failure, failedUnseen, unseenFailures } = taskVerdict(graded.task, outcomes);
  const given = outcomes.slice(0, mazes.length);
  const passesGiven = given.every((each) => each.failure === null);
  const ticks = Math.max(...given.map((each) => each.ticks));
  return rowOf(graded, failure, {
    maze: failure === null ? null : mazeNameOf(graded.task, failure, failedUnseen),
    seconds: passesGiven ? secondsOf(ticks) : null,
    unseen: unseen && {
      count: unseen.count,
      passed: unseen.count - unseenFailures.length,
      failed: unseenFailures.map(({ number }) => number),
    },
  });
}

/** The row of a hand-in that is not checked. @param problem why */
export function unreadableRow(name: string, problem: string): LessonRow {
  return {
    program: name,
    task: null,
    passed: false,
    code: "unreadable",
    maze: null,
    tick: null,
    lines: null,
    seconds: null,
    unseen: null,
    problem,
  };
}

/** The columns of `lessonFields`. */
export const lessonColumns = [
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

/** The fields of a row for a table. */
export function lessonFields(row: LessonRow): (string | number | boolean)[] {
  return [
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
  ];
}

function mazeNameOf(
  { unseen }: LessonTask,
  { maze }: Failure,
  failedUnseen: number | null,
): string | null {
  if (unseen !== null && failedUnseen !== null) return unseenName(unseen, failedUnseen);
  return maze === null ? null : `maze ${maze + 1}`;
}

function rowOf(
  { name, attempt, number }: Graded,
  failure: Failure | null,
  { maze, seconds, unseen }: Pick<LessonRow, "maze" | "seconds" | "unseen">,
): GradedRow {
  const row: LessonRow = {
    program: name,
    task: number,
    passed: failure === null,
    code: failure?.code ?? null,
    maze,
    tick: failure?.tick ?? null,
    lines: isProgram(attempt) ? attempt.rules.length : null,
    seconds,
    unseen,
  };
  return { row, failure };
}

/** Simulated seconds with at most three decimals. */
function secondsOf(ticks: number): number {
  return Number((ticks / TICKS_PER_SECOND).toFixed(3));
}
