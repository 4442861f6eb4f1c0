/** Checks a program against a challenge, and finds the line to blame in each maze where it fails. */
import { checkChallenge, type ChallengeDocument } from "@corridor/challenge";
import { findBlame, type Blame } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";
import { TICKS_PER_SECOND } from "@corridor/simulation";
import type { CheckAnswer, CheckRequest } from "./check-request.ts";

export function checkProgram({ challenge, program }: CheckRequest): CheckAnswer {
  const verdict = checkChallenge(challenge, program);
  const blames = verdict.mazes.map(({ failure }, at) =>
    failure === null ? null : blameIn(challenge, program, at),
  );
  return { verdict, blames };
}

function blameIn(challenge: ChallengeDocument, program: ProgramDocument, at: number): Blame | null {
  const maze = challenge.mazes[at];
  if (maze === undefined) return null;
  const alone = { ...challenge, mazes: [maze] };
  const { bumps, seconds } = challenge.checks;
  return findBlame({
    program,
    maze,
    ticks: seconds * TICKS_PER_SECOND,
    // With some bumps allowed, which one is to blame is no longer clear.
    endsAtBump: bumps === 0,
    passes: (other) => checkChallenge(alone, other).passed,
  });
}
