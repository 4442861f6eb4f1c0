/** What the page asks of the worker that checks challenges, and what it hears. */
import type { ChallengeDocument, Verdict } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";

export interface CheckRequest {
  challenge: ChallengeDocument;
  program: ProgramDocument;
}

export interface CheckAnswer {
  verdict: Verdict;
  /** for each maze why the program fails there; null where it passes */
  diagnoses: readonly (Diagnosis | null)[];
}
