/** The units of grading a lesson: a program in one maze of a task. */
import { checkMazeOf, countMazes, type LessonTask, type MazeOutcome } from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";
import type { Units } from "../work-share.ts";

export interface CheckJob {
  /** tasks, each with the programs that it allows */
  checks: { task: LessonTask; programs: ProgramDocument[] }[];
}

/**
 * The units of a job, task by task: all programs in the first maze, then in the next maze.
 * Alternates between the programs, as `unitsOfRuns` does.
 */
export function unitsOfChecks({ checks }: CheckJob): Units<MazeOutcome> {
  return { count: checks.reduce((sum, check) => sum + countUnits(check), 0), run };

  function run(unit: number): MazeOutcome {
    let at = unit;
    for (const check of checks) {
      const { task, programs } = check;
      const program = programs[at % programs.length];
      if (at < countUnits(check) && program !== undefined) {
        return checkMazeOf(task, Math.floor(at / programs.length), program);
      }
      at -= countUnits(check);
    }
    throw new RangeError(`no unit ${unit}`);
  }
}

/**
 * Groups the results of all units.
 * @returns for each check, the outcomes of each of its programs in the order of the mazes
 */
export function groupOutcomes(
  { checks }: CheckJob,
  outcomes: readonly MazeOutcome[],
): Map<ProgramDocument, MazeOutcome[]>[] {
  let unit = 0;
  return checks.map(({ task, programs }) => {
    const groups = new Map(
      programs.map((program): [ProgramDocument, MazeOutcome[]] => [program, []]),
    );
    for (let maze = 0; maze < countMazes(task); maze++) {
      for (const group of groups.values()) {
        const outcome = outcomes[unit++];
        if (outcome !== undefined) group.push(outcome);
      }
    }
    return groups;
  });
}

function countUnits({ task, programs }: CheckJob["checks"][number]): number {
  return programs.length * countMazes(task);
}
