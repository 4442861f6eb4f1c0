/** From a run document to the recorded run, ended where the document ends. */
import type { ReadResult } from "@corridor/protocol";
import { Recording } from "./recording.ts";
import type { RunDocument } from "./run-document.ts";

/**
 * Runs a document again and checks that it ends in the same bits.
 * @returns the recording; or the problem, where an input cannot be at its tick or the digest is another
 */
export function openRun(run: RunDocument): ReadResult<Recording> {
  const recording = new Recording(run.maze, run.program);
  for (const [index, { tick, ...input }] of run.inputs.entries()) {
    while (recording.run.tick < tick) recording.step();
    if (recording.input(input)) continue;
    return refuse(
      `inputs[${index}]`,
      input.do === "maze" ? "a maze with a block where the robot stands" : `a ${input.do}`,
      input.do === "maze"
        ? "a maze with room for the robot"
        : "an input while a hand or a script drives",
    );
  }
  while (recording.run.tick < run.ticks) recording.step();
  const digest = recording.run.digest();
  if (digest === run.digest) return { ok: true, value: recording };
  return refuse("digest", run.digest, `${digest}, which is what this run ends in here`);
}

function refuse(path: string, found: string, expected: string): ReadResult<never> {
  return { ok: false, problems: [{ path, found, expected }] };
}
