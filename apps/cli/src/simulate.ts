/** `simulate`: runs one program in one maze and prints one line of JSON. */
import { CompiledProgram } from "@corridor/program";
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { replayDigest, type Inputs } from "@corridor/simulation";
import { simulateArguments } from "./arguments.ts";
import { exitCodes, runFields, type Command } from "./command.ts";
import { readFiles } from "./read-files.ts";
import { jsonLine } from "./report.ts";
import type { RunLimits } from "./run-limits.ts";
import { runProgram } from "./run-result.ts";

const help = `Usage:
  corridor simulate --maze FILE --program FILE [--seconds N] [--until time|goal|bump]
  corridor simulate --maze FILE (--program FILE | --commands FILE) --digest [--seconds N]

Runs one program in one maze, with the same simulation as the page, and prints one line of JSON.

Options:
  --maze FILE      maze, saved by the page or written by hand
  --program FILE   program, saved by the page or written by hand
  --seconds N      maximum simulated time, from 1/60 (one tick) to 86400; default: 120
  --until time     run for all seconds (default)
  --until goal     stop when the robot reaches a goal
  --until bump     stop at the first bump
  --digest         print a digest of all snapshots; equal inputs have equal digests
  --commands FILE  with --digest, timed commands instead of a program, such as
                   [{ "tick": 0, "command": { "action": "left 90" } }]
  --help           print this text

Result:
${runFields}

${exitCodes("success, even if the robot bumps or misses the goal", null)}`;

export const command: Command = {
  help,
  run: (args, { print }) => {
    print(simulate(args));
    return 0;
  },
};

/** @returns the lines to print @throws InputError if the arguments or files are invalid */
function simulate(args: readonly string[]): string[] {
  const { maze, program, commands, limits, digest } = simulateArguments(args);
  const documents = readFiles({
    mazes: [maze],
    programs: program === null ? [] : [program],
    commands: commands === null ? [] : [commands],
  });
  return documents.mazes.flatMap((document) => {
    if (!digest) {
      return documents.programs.map((each) => jsonLine(runProgram(document, each, limits)));
    }
    const programs = documents.programs.map((each) => new CompiledProgram(each));
    return [...programs, ...documents.commands].map((driver) =>
      digestLine({ maze: document, driver }, limits),
    );
  });
}

function digestLine(inputs: Inputs, { seconds }: RunLimits): string {
  const ticks = Math.round(seconds * TICKS_PER_SECOND);
  return JSON.stringify({ ticks, digest: replayDigest(inputs, ticks) });
}
