/** What a check of a program in all mazes of a task finds. */
import type { LessonTask, MazeOutcome, TaskVerdict } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { ProgramDocument } from "@corridor/program";

export interface CheckRequest {
  task: LessonTask;
  program: ProgramDocument;
}

/** The verdict on a program in the given and the unseen mazes of a task. */
export interface CheckedTask extends TaskVerdict {
  /** one result per given maze; empty if the task does not allow the program */
  mazes: readonly MazeOutcome[];
}

export interface CheckAnswer {
  verdict: CheckedTask;
  /** for each given maze why the program fails there; null if it passes */
  diagnoses: readonly (Diagnosis | null)[];
  /** the same for the unseen maze of the verdict's failure; null without one */
  unseenDiagnosis: Diagnosis | null;
}
