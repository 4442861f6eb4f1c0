/** Runs a command and ends the process with its exit code. */
import { basename } from "node:path";
import type { Command } from "./command.ts";
import { InputError } from "./input-error.ts";

/**
 * Sets the exit code of the process. Exit code 2: invalid input; prints one problem per line to
 * standard error.
 * @param run returns the exit code
 */
export async function runProcess(run: () => Promise<number>): Promise<void> {
  endWhenUnread();
  try {
    process.exitCode = await run();
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    process.stderr.write(`${error.lines.join("\n")}\n`);
    process.exitCode = 2;
  }
}

/** The exit code that shells report for a program which SIGPIPE ended. Node.js ignores SIGPIPE. */
const UNREAD = 141;

/** Ends the process when its reader has enough, such as `head -1`, instead of with a stack trace. */
function endWhenUnread(): void {
  process.stdout.on("error", (error: NodeJS.ErrnoException) => {
    if (error.code !== "EPIPE") throw error;
    process.exit(UNREAD);
  });
}

/** Runs a command or prints its help. @param entry see `Context` @returns its exit code */
export async function runCommand(
  command: Command,
  args: readonly string[],
  entry: URL,
): Promise<number> {
  // What stands after -- belongs to another program.
  const own = args.includes("--") ? args.slice(0, args.indexOf("--")) : args;
  if (own.includes("--help") || own.includes("-h")) {
    print([withProgram(command.help, entry)]);
    return 0;
  }
  return command.run(args, { print, write, entry });
}

/** The file that a relay serves. */
const SERVED = "corridor-cli.mjs";

/** A text in which `corridor` is the program, with the words that start this program. */
export function withProgram(text: string, entry: URL): string {
  const isServed = basename(entry.pathname) === SERVED;
  return isServed ? text.replaceAll("corridor ", `node ${SERVED} `) : text;
}

export function print(lines: readonly string[]): void {
  if (lines.length > 0) write(`${lines.join("\n")}\n`);
}

function write(content: string | Uint8Array): void {
  process.stdout.write(content);
}
