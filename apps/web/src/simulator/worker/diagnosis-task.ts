/** The task of a challenge in one of its mazes, in the terms of the diagnosis. */
import {
  findViolation,
  checkChallenge,
  GoalTracker,
  type ChallengeDocument,
} from "@corridor/challenge";
import type { DiagnosisTask } from "@corridor/coach";
import { TICKS_PER_SECOND } from "@corridor/simulation";

/**
 * @param index of the maze
 * @param isWhole whether the program alone has driven since the start; otherwise only the goal
 *   counts
 */
export function diagnosisTask(
  challenge: ChallengeDocument,
  index: number,
  isWhole = true,
): DiagnosisTask {
  const { goal, checks, mazes } = challenge;
  const maze = mazes[index];
  if (maze === undefined) throw new RangeError(`The challenge has no maze ${index}.`);
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
    allows: (program) => findViolation(challenge, program) === null,
    solvesAll: (program) => checkChallenge(challenge, program).passed,
    mazes: mazes.length,
  };
}
