/**
 * Filters advice while a challenge is open. The challenge's own program is a task to solve, so it
 * gets no advice. Advice without a fix that the challenge permits is hidden too.
 */
import type { Advice } from "@corridor/coach";
import { isSameBehaviour, type ProgramDocument } from "@corridor/program";
import type { ChallengeState } from "../challenge/challenge-store.ts";
import { allowsFix } from "./fix-rights.ts";

export function concernsReader(
  { fix }: Pick<Advice, "fix">,
  program: ProgramDocument,
  { challenge, rights }: Pick<ChallengeState, "challenge" | "rights">,
): boolean {
  if (challenge === null) return true;
  if (challenge.program !== null && isSameBehaviour(program, challenge.program)) return false;
  return fix !== null && allowsFix(fix, program.rules.length, rights);
}
