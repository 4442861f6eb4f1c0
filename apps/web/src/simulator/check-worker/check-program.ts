/** Checks a program against a challenge, with a diagnosis for each maze where it fails. */
import { checkChallenge, type ChallengeDocument } from "@corridor/challenge";
import { diagnoseProgram, type Diagnosis } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { Simulation } from "@corridor/simulation";
import type { CheckAnswer, CheckRequest } from "../protocol/check-request.ts";
import { diagnosisTask } from "../worker/diagnosis-task.ts";

export function checkProgram({ challenge, program }: CheckRequest): CheckAnswer {
  const verdict = checkChallenge(challenge, program);
  const diagnoses = verdict.mazes.map(({ failure }, at) =>
    failure === null ? null : diagnosisIn(challenge, program, at),
  );
  return { verdict, diagnoses };
}

function diagnosisIn(
  challenge: ChallengeDocument,
  program: ProgramDocument,
  at: number,
): Diagnosis | null {
  const maze = challenge.mazes[at];
  if (maze === undefined) return null;
  const state = new Simulation(maze).save();
  return diagnoseProgram({ maze, program, state }, diagnosisTask(challenge, at));
}
