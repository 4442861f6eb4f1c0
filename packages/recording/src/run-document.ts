/** The run document, `corridor/run` version 1: the starting documents and the inputs of a run. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { TimedInput } from "./run-input.ts";

export interface RunDocument {
  format: "corridor/run";
  version: 1;
  name: string;
  /** the maze and the program at the start of the run */
  maze: MazeDocument;
  program: ProgramDocument;
  /** seed for random values; always 0 in version 1, which has none */
  seed: number;
  /** length of the run */
  ticks: number;
  /** in tick order */
  inputs: TimedInput[];
  /** `SnapshotDigest` of the run: 16 hexadecimal digits */
  digest: string;
}
