/** What the page asks of the worker that checks challenges, and what it hears. */
import type { ChallengeDocument, Verdict } from "@corridor/challenge";
import type { Blame } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";

export interface CheckRequest {
  challenge: ChallengeDocument;
  program: ProgramDocument;
}

export interface CheckAnswer {
  verdict: Verdict;
  /** for each maze which line led the robot astray; null where it passes, and where none can be named */
  blames: readonly (Blame | null)[];
}
