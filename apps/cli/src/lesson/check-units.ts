/** The units of grading a lesson: a program in one maze of a task. */
import {
  checkUnitAt,
  countCheckUnits,
  runCheckUnit,
  type Attempt,
  type CheckJob,
  type MazeOutcome,
} from "@corridor/challenge";
import type { Units } from "../work-share.ts";

export function unitsOfChecks(job: CheckJob): Units<MazeOutcome> {
  return { count: countCheckUnits(job), run: (unit) => runCheckUnit(job, unit) };
}

/**
 * Groups the results of all units.
 * @returns for each check, the outcomes of each of its attempts in the order of the mazes
 */
export function groupOutcomes(
  job: CheckJob,
  outcomes: readonly MazeOutcome[],
): Map<Attempt, MazeOutcome[]>[] {
  const lists = job.checks.map(({ attempts }) => attempts.map((): MazeOutcome[] => []));
  for (const [unit, outcome] of outcomes.entries()) {
    const { check, attempt } = checkUnitAt(job, unit);
    lists[check]?.[attempt]?.push(outcome);
  }
  return job.checks.map(
    ({ attempts }, check) => new Map(attempts.map((each, at) => [each, lists[check]?.[at] ?? []])),
  );
}
