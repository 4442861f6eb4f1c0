/** A task in one of its mazes, in the terms of the diagnosis. */
import {
  findViolation,
  checkChallenge,
  GoalTracker,
  rightsOf,
  type Task,
} from "@corridor/challenge";
import type { Diagnosis, DiagnosisTask } from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import { TICKS_PER_SECOND } from "@corridor/protocol";

/** A task that may hide which line caused a failure. */
export interface PageTask extends DiagnosisTask {
  hasBlame: boolean;
}

/** A diagnosis as the task allows it: without blame, only what happened. */
export function allowedDiagnosis(diagnosis: Diagnosis, { hasBlame }: PageTask): Diagnosis {
  if (hasBlame) return diagnosis;
  const { event } = diagnosis;
  const fact = event.kind === "bump" ? { ...event, line: null } : event;
  return { event: fact, cause: null, fixes: [] };
}

/**
 * @param maze a given or an unseen maze of the task
 * @param isWhole whether the program alone has driven since the start; otherwise only the goal
 *   counts
 */
export function diagnosisTask(task: Task, maze: MazeDocument, isWhole = true): PageTask {
  const { goal, checks, mazes } = task;
  const newSolvedCheck: DiagnosisTask["newSolvedCheck"] = () => {
    const watch = new GoalTracker(goal, maze);
    let standing = 0;
    return (robot) => {
      watch.visit(robot.cell);
      standing = robot.report().motion === "stop" ? standing + 1 : 0;
      return watch.isMet(robot, standing > 1);
    };
  };
  return {
    until: checks.seconds * TICKS_PER_SECOND,
    bumps: checks.bumps,
    newSolvedCheck: isWhole || goal.kind === "reach" ? newSolvedCheck : null,
    allows: (program) => findViolation(task, program) === null,
    solvesAll: (program) => checkChallenge(task, program).passed,
    mazes: mazes.length,
    hasBlame: rightsOf(task).help.has("blame"),
  };
}
