/** A command of `corridor`. */

/** What a command needs from the command line. */
export interface Context {
  /** prints lines to standard output */
  print: (lines: readonly string[]) => void;
  /** entry of the command line, from which commands start their worker threads */
  entry: URL;
}

export interface Command {
  /** complete description, printed by `--help` */
  help: string;
  /**
   * Runs the command. @returns the exit code: 0 for success, 1 if a check failed
   * @throws InputError if the arguments or files are invalid
   */
  run: (args: readonly string[], context: Context) => number | Promise<number>;
}

/** The last part of every help text. */
export const EXIT_CODES = `Exit codes:
  0  success
  1  conformance: at least one check failed or could not be tested
  2  the arguments or files are invalid; prints one problem per line to standard error`;
