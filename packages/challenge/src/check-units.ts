/**
 * The units of a check: one attempt in one maze of a task. Workers of the page and threads of
 * `grade` share them.
 */
import type { Attempt } from "./check-challenge.ts";
import { checkMazeOf, countMazes } from "./check-task.ts";
import type { LessonTask } from "./lesson-document.ts";
import type { MazeOutcome } from "./verdict.ts";

export interface CheckJob {
  /** tasks, each with the attempts that it allows */
  checks: readonly { task: LessonTask; attempts: readonly Attempt[] }[];
}

/** Indices in a job. */
export interface CheckUnit {
  check: number;
  attempt: number;
  /** see `mazeOf` */
  maze: number;
}

/** Number of units of a job. */
export function countCheckUnits({ checks }: CheckJob): number {
  return checks.reduce((sum, check) => sum + unitsOf(check), 0);
}

/**
 * Returns a unit of a job. The order is task by task: all attempts in the first maze, then in the
 * next maze. Alternates between the programs, so that V8 has seen the types of all programs before
 * it optimises the loop.
 * @param unit from 0
 * @throws RangeError if the job has no such unit
 */
export function checkUnitAt({ checks }: CheckJob, unit: number): CheckUnit {
  let at = unit;
  for (const [check, each] of checks.entries()) {
    const { length } = each.attempts;
    if (at < unitsOf(each)) {
      return { check, attempt: at % length, maze: Math.floor(at / length) };
    }
    at -= unitsOf(each);
  }
  throw new RangeError(`The job has no unit ${unit}.`);
}

/** Runs a unit of a job. @throws RangeError if the job has no such unit */
export function runCheckUnit(job: CheckJob, unit: number): MazeOutcome {
  const { check, attempt, maze } = checkUnitAt(job, unit);
  const { task, attempts } = job.checks[check] ?? {};
  const chosen = attempts?.[attempt];
  if (task === undefined || chosen === undefined) throw new RangeError(`no unit ${unit}`);
  return checkMazeOf(task, maze, chosen);
}

function unitsOf({ task, attempts }: CheckJob["checks"][number]): number {
  return attempts.length * countMazes(task);
}
