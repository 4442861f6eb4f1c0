/** Bad input of the command line: every problem on a line of its own, and exit code 2. */
export class InputError extends Error {
  override readonly name = "InputError";
  /** one line a problem: file or option, field, found, expected */
  readonly lines: readonly string[];

  constructor(lines: readonly string[]) {
    super(lines.join("\n"));
    this.lines = lines;
  }
}
