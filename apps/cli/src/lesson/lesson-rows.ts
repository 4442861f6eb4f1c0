/** The lines of the output of `grade --challenge`: one for each attempt and task. */
import {
  taskVerdict,
  unseenName,
  type Attempt,
  type Failure,
  type FailureCode,
  type LessonTask,
  type MazeOutcome,
} from "@corridor/challenge";
import { TICKS_PER_SECOND } from "@corridor/simulation";
import { round } from "../round.ts";
import { describeFailure } from "./describe-failure.ts";

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
  /** number of lines of the program, without "otherwise"; null for a manual drive */
  lines: number | null;
  /** simulated time in the slowest given maze; null unless the attempt passes in all of them */
  seconds: number | null;
  /** null if no unseen mazes were run */
  unseen: { count: number; passed: number; failed: number[] } | null;
  /** set for an unreadable hand-in only */
  problem?: string;
}

/** A line of the output with the sentence that describes its failure. */
export interface GradedLine {
  row: LessonRow;
  /** null if the attempt passes */
  message: string | null;
}

export interface Graded {
  name: string;
  attempt: Attempt;
  /** number of the task, from 1 */
  number: number;
  task: LessonTask;
}

/** The line of an attempt that the task does not allow. */
export function violationLine(graded: Graded, violation: Failure): GradedLine {
  return lineOf(graded, violation, { maze: null, seconds: null, unseen: null });
}

/** The line of an attempt that ran. @param outcomes of all mazes of the task */
export function checkedLine(graded: Graded, outcomes: readonly MazeOutcome[]): GradedLine {
  const { mazes, unseen } = graded.task;
  const { failure, failedUnseen, unseenFailures } = taskVerdict(graded.task, outcomes);
  const given = outcomes.slice(0, mazes.length);
  const passesGiven = given.every((each) => each.failure === null);
  const ticks = Math.max(...given.map((each) => each.ticks));
  return lineOf(graded, failure, {
    maze: failure === null ? null : mazeNameOf(graded.task, failure, failedUnseen),
    seconds: passesGiven ? round(ticks / TICKS_PER_SECOND, 3) : null,
    unseen: unseen && {
      count: unseen.count,
      passed: unseen.count - unseenFailures.length,
      failed: unseenFailures.map(({ number }) => number),
    },
  });
}

function mazeNameOf(
  { unseen }: LessonTask,
  { maze }: Failure,
  failedUnseen: number | null,
): string | null {
  if (unseen !== null && failedUnseen !== null) return unseenName(unseen, failedUnseen);
  return maze === null ? null : `maze ${maze + 1}`;
}

function lineOf(
  { name, attempt, number, task }: Graded,
  failure: Failure | null,
  { maze, seconds, unseen }: Pick<LessonRow, "maze" | "seconds" | "unseen">,
): GradedLine {
  const row: LessonRow = {
    program: name,
    task: number,
    passed: failure === null,
    code: failure?.code ?? null,
    maze,
    tick: failure?.tick ?? null,
    lines: "rules" in attempt ? attempt.rules.length : null,
    seconds,
    unseen,
  };
  return { row, message: failure && describeFailure(failure, task, attempt) };
}

/** The line of a hand-in that is not checked. @param problem why */
export function unreadableLine(name: string, problem: string): GradedLine {
  const row: LessonRow = {
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
  return { row, message: problem };
}
