/** A command of `corridor`. */

/** What a command needs from the command line. */
export interface Context {
  /** prints lines to standard output */
  print: (lines: readonly string[]) => void;
  /** writes the content of a file to standard output */
  write: (content: string | Uint8Array) => void;
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

/**
 * The last part of every help text.
 * @param failure meaning of exit code 1; null if the command does not return it
 */
export function exitCodes(success: string, failure: string | null): string {
  return [
    "Exit codes:",
    `  0  ${success}`,
    ...(failure === null ? [] : [`  1  ${failure}`]),
    "  2  the arguments or files are invalid; prints one problem per line to standard error",
  ].join("\n");
}

/** Help text: the fields of a run, as `simulate` and `grade` print them. */
export const runFields = `  ticks, seconds             length of the run; a tick is 1/60 s
  bumps                      number of bumps
  visitedCells, openCells    cells that the robot visited; cells without a block
  distance                   driven distance in cm
  goal                       whether, and at which tick, the robot reached a goal
  pose                       final position in cm, and degrees clockwise from north
  lines                      number of decisions of each line, from 0, and of the default`;
