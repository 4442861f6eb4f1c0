/**
 * Filters advice while a challenge is open. The challenge's own program is a task to solve, so it
 * gets no advice. Advice without a fix that the challenge permits is hidden too.
 */
import type { Advice } from "@corridor/coach";
import { isSameBehaviour, type ProgramDocument } from "@corridor/program";
import { openTask, showsHelp, type ChallengeState } from "../challenge/challenge-store.ts";
import { allowsFix } from "./fix-rights.ts";

export function concernsReader(
  { fix }: Pick<Advice, "fix">,
  program: ProgramDocument,
  state: Pick<ChallengeState, "lesson" | "index" | "rights">,
): boolean {
  const { rights } = state;
  const task = openTask(state);
  if (task === null) return true;
  if (!showsHelp(rights, "advice")) return false;
  if (task.program !== null && isSameBehaviour(program, task.program)) return false;
  return fix !== null && allowsFix(fix, program.rules.length, rights);
}
