/**
 * Invalid arguments or files. The command line prints one problem per line and exits with code 2.
 */
export class InputError extends Error {
  override readonly name = "InputError";
  /** One line per problem: file or option, field, found value, expected value. */
  readonly lines: readonly string[];

  constructor(lines: readonly string[]) {
    super(lines.join("\n"));
    this.lines = lines;
  }
}
