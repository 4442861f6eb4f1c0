/**
 * Checks an attempt at a task of a lesson in its given and its unseen mazes, one maze at a time, so
 * that several workers can share a check.
 */
import type { MazeDocument } from "@corridor/maze";
import { checkMaze, type Attempt } from "./check-challenge.ts";
import type { LessonTask } from "./lesson-document.ts";
import { unseenMaze } from "./unseen-mazes.ts";
import type { Failure, MazeOutcome } from "./verdict.ts";

/** Number of mazes of a task: the given ones, then the unseen ones. */
export function countMazes({ mazes, unseen }: LessonTask): number {
  return mazes.length + (unseen?.count ?? 0);
}

/**
 * Returns a maze of a task.
 * @param index the given mazes from 0, then the unseen ones
 * @throws RangeError if the task has no such maze
 */
export function mazeOf(task: LessonTask, index: number): MazeDocument {
  const given = task.mazes[index];
  if (given !== undefined) return given;
  const { unseen } = task;
  if (unseen === null || index >= countMazes(task)) {
    throw new RangeError(`The task has no maze ${index}.`);
  }
  return unseenMaze(unseen, index - task.mazes.length + 1);
}

/** Runs an attempt that the task allows in one of its mazes. @param index see `mazeOf` */
export function checkMazeOf(task: LessonTask, index: number, attempt: Attempt): MazeOutcome {
  const isGiven = index < task.mazes.length;
  return checkMaze(task, mazeOf(task, index), attempt, isGiven ? index : null);
}

/** An unseen maze in which an attempt failed. */
export interface UnseenFailure {
  /** from 1 */
  number: number;
  failure: Failure;
}

export interface TaskVerdict {
  passed: boolean;
  /** the first failure in a given maze, or in an unseen one if too few of those passed, or null */
  failure: Failure | null;
  /** number of the unseen maze of `failure`; null if it is a given one */
  failedUnseen: number | null;
  /** every unseen maze in which the attempt failed, even if it passed in enough of them */
  unseenFailures: readonly UnseenFailure[];
}

/** Decides a check. @param outcomes of all mazes of the task, in the order of `mazeOf` */
export function taskVerdict(task: LessonTask, outcomes: readonly MazeOutcome[]): TaskVerdict {
  const given = outcomes.slice(0, task.mazes.length);
  const failure = given.find((each) => each.failure !== null)?.failure ?? null;
  const unseenFailures = outcomes
    .slice(task.mazes.length)
    .flatMap((each, at) =>
      each.failure === null ? [] : [{ number: at + 1, failure: each.failure }],
    );
  if (failure !== null) return { passed: false, failure, failedUnseen: null, unseenFailures };
  const { count = 0, pass = 0 } = task.unseen ?? {};
  const [first] = unseenFailures;
  if (first === undefined || count - unseenFailures.length >= pass) {
    return { passed: true, failure: null, failedUnseen: null, unseenFailures };
  }
  return { passed: false, failure: first.failure, failedUnseen: first.number, unseenFailures };
}
