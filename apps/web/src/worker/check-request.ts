/** What the page asks of the worker that checks challenges; the answer is a `Verdict`. */
import type { ChallengeDocument } from "@corridor/challenge";
import type { ProgramDocument } from "@corridor/program";

export interface CheckRequest {
  challenge: ChallengeDocument;
  program: ProgramDocument;
}
