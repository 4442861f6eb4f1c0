/**
 * Corridor on the command line: `simulate` and `grade`, with the simulation of the page.
 * Exit code 0: done; 2: bad input, one line a problem on standard error and nothing on standard output.
 */
import { InputError } from "./input-error.ts";

const USAGE = `Usage:
  npm run --silent simulate -- --maze FILE --program FILE [--seconds 120] [--until time|goal|bump]
  npm run --silent simulate -- --maze FILE (--program FILE | --commands FILE) --digest [--seconds 120]
  npm run --silent grade -- --program FILE... --maze FILE... [--seconds 300] [--until time|goal|bump] [--csv]`;

/** Carries out the words of the command line, prints the result and sets the exit code. */
export async function runCommandLine([command, ...words]: readonly string[]): Promise<void> {
  try {
    const lines = await linesOf(command, words);
    if (lines.length > 0) process.stdout.write(`${lines.join("\n")}\n`);
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    process.stderr.write(`${error.lines.join("\n")}\n`);
    process.exitCode = 2;
  }
}

async function linesOf(command: string | undefined, words: readonly string[]): Promise<string[]> {
  if (words.includes("--help")) return [USAGE];
  if (command === "simulate") return (await import("./simulate.ts")).simulate(words);
  if (command === "grade") return (await import("./grade.ts")).grade(words);
  throw new InputError([
    `command: found ${JSON.stringify(command ?? "nothing")}, expected simulate or grade`,
    ...USAGE.split("\n"),
  ]);
}
