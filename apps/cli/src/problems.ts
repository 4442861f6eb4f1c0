/** Bad input of the command line: every problem on a line of its own, and exit code 2. */
import { describeProblem, type FieldProblem } from "@corridor/protocol";

export class InputError extends Error {
  override readonly name = "InputError";
  /** one line a problem: file or option, field, found, expected */
  readonly lines: readonly string[];

  constructor(lines: readonly string[]) {
    super(lines.join("\n"));
    this.lines = lines;
  }
}

/** The problems of one file, one line each. */
export function fileProblems(file: string, problems: readonly FieldProblem[]): string[] {
  return problems.map((problem) => `${file}: ${describeProblem(problem)}`);
}
