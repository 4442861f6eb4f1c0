/** The content of a completion code. */
import type { Attempt } from "@corridor/challenge";

/** Proof that a program, or a drive, passes a task of a lesson: every reader checks it. */
export interface CompletionCode {
  /** `lessonMark` of the lesson */
  lesson: string;
  /** index of the task, from 0 */
  task: number;
  /** the program without its name, or the commands of a drive */
  attempt: Attempt;
}
