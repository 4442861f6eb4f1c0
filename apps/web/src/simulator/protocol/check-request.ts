/** Requests to the worker that checks challenges, and its answers. */
import type { ChallengeDocument, Verdict } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";

export interface CheckRequest {
  challenge: ChallengeDocument;
  program: ProgramDocument;
}

export interface CheckAnswer {
  verdict: Verdict;
  /** for each maze why the program fails there; null if it passes */
  diagnoses: readonly (Diagnosis | null)[];
}
