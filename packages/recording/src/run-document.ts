/** The run document, `corridor/run` version 1: what a run began with and what came to it from outside. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { TimedInput } from "./run-input.ts";

export interface RunDocument {
  format: "corridor/run";
  version: 1;
  name: string;
  /** the maze and the program that the run began with */
  maze: MazeDocument;
  program: ProgramDocument;
  /** for what is random in a run; nothing is in version 1 */
  seed: number;
  /** how long the run is */
  ticks: number;
  /** in the order of their ticks */
  inputs: TimedInput[];
  /** of the snapshots of the run, as `SnapshotDigest` gives it: 16 hexadecimal digits */
  digest: string;
}
