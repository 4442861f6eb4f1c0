/**
 * The command line of Corridor. Exit code 2: invalid input; prints one problem per line to standard
 * error.
 */
import leven from "leven";
import { exitCodes, type Command } from "./command.ts";
import { InputError } from "./input-error.ts";

interface Entry {
  name: string;
  summary: string;
  /** Loads the modules of this command only. */
  load: () => Promise<{ command: Command }>;
}

const entries: readonly Entry[] = [
  {
    name: "simulate",
    summary: "run one program in one maze",
    load: async () => import("./simulate.ts"),
  },
  {
    name: "grade",
    summary: "run every program in every maze, on all cores",
    load: async () => import("./grade.ts"),
  },
  {
    name: "conformance",
    summary: "check that a robot host keeps every promise that scripts rely on",
    load: async () => import("./conformance.ts"),
  },
];

const HELP = `Usage: corridor COMMAND [OPTIONS]

Commands:
${entries.map(({ name, summary }) => `  ${name.padEnd(11)}  ${summary}`).join("\n")}

corridor COMMAND --help describes a command and its options.

${exitCodes("success; conformance: PASSED", "conformance: FAILED or INCOMPLETE")}`;

/** Runs the command, prints its result and sets the exit code. @param entry see `Context` */
export async function runCommandLine(args: readonly string[], entry: URL): Promise<void> {
  try {
    process.exitCode = await run(args, entry);
  } catch (error) {
    if (!(error instanceof InputError)) throw error;
    process.stderr.write(`${error.lines.join("\n")}\n`);
    process.exitCode = 2;
  }
}

async function run([name, ...args]: readonly string[], entry: URL): Promise<number> {
  if (name === undefined) throw new InputError(["Expected a command.", "", HELP]);
  const found = entries.find((each) => each.name === name);
  if (found === undefined) {
    if (!["--help", "-h", "help"].includes(name)) throw new InputError([unknownCommand(name)]);
    print([HELP]);
    return 0;
  }
  const { command } = await found.load();
  if (args.includes("--help") || args.includes("-h")) {
    print([command.help]);
    return 0;
  }
  return command.run(args, { print, entry });
}

function print(lines: readonly string[]): void {
  if (lines.length > 0) process.stdout.write(`${lines.join("\n")}\n`);
}

function unknownCommand(found: string): string {
  const names = entries.map(({ name }) => name);
  const [nearest] = names
    .filter((name) => resembles(name, found))
    .toSorted((a, b) => leven(a, found) - leven(b, found));
  const advice =
    nearest === undefined ? `The commands are ${names.join(", ")}.` : `Did you mean ${nearest}?`;
  return `Unknown command ${JSON.stringify(found)}. ${advice} Run corridor --help to see all commands.`;
}

/** Whether at most a third of the letters differ, or `found` is the beginning of the name. */
function resembles(name: string, found: string): boolean {
  return name.startsWith(found) || leven(name, found) <= Math.ceil(name.length / 3);
}
