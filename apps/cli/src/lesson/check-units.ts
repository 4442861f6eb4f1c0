/** The units of grading a lesson: an attempt in one maze of a task. */
import {
  checkMazeOf,
  countMazes,
  type Attempt,
  type LessonTask,
  type MazeOutcome,
} from "@corridor/challenge";
import type { Units } from "../work-share.ts";

export interface CheckJob {
  /** tasks, each with the attempts that it allows */
  checks: { task: LessonTask; attempts: Attempt[] }[];
}

/**
 * The units of a job, task by task: all attempts in the first maze, then in the next maze.
 * Alternates between the attempts, as `unitsOfRuns` does.
 */
export function unitsOfChecks({ checks }: CheckJob): Units<MazeOutcome> {
  return { count: checks.reduce((sum, check) => sum + countUnits(check), 0), run };

  function run(unit: number): MazeOutcome {
    let at = unit;
    for (const check of checks) {
      const { task, attempts } = check;
      const attempt = attempts[at % attempts.length];
      if (at < countUnits(check) && attempt !== undefined) {
        return checkMazeOf(task, Math.floor(at / attempts.length), attempt);
      }
      at -= countUnits(check);
    }
    throw new RangeError(`no unit ${unit}`);
  }
}

/**
 * Groups the results of all units.
 * @returns for each check, the outcomes of each of its attempts in the order of the mazes
 */
export function groupOutcomes(
  { checks }: CheckJob,
  outcomes: readonly MazeOutcome[],
): Map<Attempt, MazeOutcome[]>[] {
  let unit = 0;
  return checks.map(({ task, attempts }) => {
    const groups = new Map(attempts.map((attempt): [Attempt, MazeOutcome[]] => [attempt, []]));
    for (let maze = 0; maze < countMazes(task); maze++) {
      for (const group of groups.values()) {
        const outcome = outcomes[unit++];
        if (outcome !== undefined) group.push(outcome);
      }
    }
    return groups;
  });
}

function countUnits({ task, attempts }: CheckJob["checks"][number]): number {
  return attempts.length * countMazes(task);
}
