/** The lines of the output of `grade --challenge`: a row with the sentence that explains it. */
import { unreadableRow, type Graded, type GradedRow, type LessonRow } from "@corridor/challenge";
import { describeFailure } from "./describe-failure.ts";

export interface GradedLine {
  row: LessonRow;
  /** null if the attempt passes */
  message: string | null;
}

/** The line of an attempt at a task. */
export function gradedLine(
  { row, failure }: GradedRow,
  { task, attempt }: Pick<Graded, "task" | "attempt">,
): GradedLine {
  return { row, message: failure && describeFailure(failure, task, attempt) };
}

/** The line of a hand-in that is not checked. @param problem why */
export function unreadableLine(name: string, problem: string): GradedLine {
  return { row: unreadableRow(name, problem), message: problem };
}
