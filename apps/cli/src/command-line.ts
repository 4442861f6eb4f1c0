/**
 * The command line of Corridor: `simulate` and `grade`, with the same simulation as the page.
 * Exit code 0: success. Exit code 2: invalid input; prints one problem per line to standard error
 * and nothing to standard output.
 */
import { InputError } from "./input-error.ts";

const USAGE = `Usage:
  npm run --silent simulate -- --maze FILE --program FILE [--seconds 120] [--until time|goal|bump]
  npm run --silent simulate -- --maze FILE (--program FILE | --commands FILE) --digest [--seconds 120]
  npm run --silent grade -- --program FILE... --maze FILE... [--seconds 300] [--until time|goal|bump] [--csv | --why]`;

/** Runs the command, prints its result and sets the exit code. */
export async function runCommandLine([command, ...args]: readonly string[]): Promise<void> {
  try {
    const lines = await linesOf(command, args);
    if (lines.length > 0) process.stdout.write(`${lines.join("\n")}\n`);
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    process.stderr.write(`${error.lines.join("\n")}\n`);
    process.exitCode = 2;
  }
}

async function linesOf(command: string | undefined, args: readonly string[]): Promise<string[]> {
  if (args.includes("--help")) return [USAGE];
  if (command === "simulate") return (await import("./simulate.ts")).simulate(args);
  if (command === "grade") return (await import("./grade.ts")).grade(args);
  throw new InputError([
    `command: found ${JSON.stringify(command ?? "nothing")}, expected simulate or grade`,
    ...USAGE.split("\n"),
  ]);
}
