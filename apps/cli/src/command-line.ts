/** The command line of Corridor: finds the command. */
import leven from "leven";
import { exitCodes, type Command } from "./command.ts";
import { InputError } from "./input-error.ts";
import { print, runCommand, withProgram } from "./run-command.ts";

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
    summary: "run every program in every maze, or check them against a lesson",
    load: async () => import("./grade.ts"),
  },
  {
    name: "report",
    summary: "show times, lines and answers of a class from its tables",
    load: async () => import("./study/study-command.ts"),
  },
  {
    name: "maze",
    summary: "check a contest maze, or convert a maze to another format",
    load: async () => import("./maze-command.ts"),
  },
  {
    name: "conformance",
    summary: "check that a robot host keeps every promise that scripts rely on",
    load: async () => import("./conformance.ts"),
  },
  {
    name: "ros",
    summary: "let ROS programs that accept only a host and a port drive a robot",
    load: async () => import("./bridges/ros/ros-command.ts"),
  },
  {
    name: "mcp",
    summary: "let the host of an AI agent start a program that drives a robot",
    load: async () => import("./bridges/mcp/mcp-command.ts"),
  },
  {
    name: "mms",
    summary: "start a micromouse program, which drives a robot",
    load: async () => import("./bridges/mms/mms-command.ts"),
  },
  {
    name: "viple",
    summary: "let diagrams of ASU VIPLE drive a robot",
    load: async () => import("./bridges/viple/viple-command.ts"),
  },
];

const HELP = `Usage: corridor COMMAND [OPTIONS]

Commands:
${entries.map(({ name, summary }) => `  ${name.padEnd(11)}  ${summary}`).join("\n")}

corridor COMMAND --help describes a command and its options.

${exitCodes(
  "success; conformance: PASSED",
  "conformance: FAILED or INCOMPLETE; grade: --require is not met; ros, mcp, mms, viple: the robot cannot be used",
)}`;

/**
 * Runs the command that the first argument names.
 * @param entry see `Context`
 * @returns its exit code
 */
export async function runCommandLine(
  [name, ...args]: readonly string[],
  entry: URL,
): Promise<number> {
  const help = withProgram(HELP, entry);
  if (name === undefined) throw new InputError(["Expected a command.", "", help]);
  const found = entries.find((each) => each.name === name);
  if (found === undefined) {
    if (!["--help", "-h", "help"].includes(name)) {
      throw new InputError([withProgram(unknownCommand(name), entry)]);
    }
    print([help]);
    return 0;
  }
  const { command } = await found.load();
  return runCommand(command, args, entry);
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
