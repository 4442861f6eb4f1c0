/** `simulate`: runs one program in one maze and prints one line of JSON. */
import { CompiledProgram } from "@corridor/program";
import { replayDigest, TICKS_PER_SECOND, type Inputs } from "@corridor/simulation";
import { simulateArguments } from "./arguments.ts";
import { readFiles } from "./read-files.ts";
import { jsonLine } from "./report.ts";
import type { RunLimits } from "./run-limits.ts";
import { runProgram } from "./run-result.ts";

/** @returns the lines to print @throws InputError if the arguments or files are invalid */
export function simulate(args: readonly string[]): string[] {
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
