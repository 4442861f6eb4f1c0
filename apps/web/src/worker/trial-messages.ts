/** What the page asks of a worker that tries programs in other mazes, and what it answers. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { WrittenRun } from "@corridor/recording";
import type { TrialMazes, TrialResult } from "./maze-trial.ts";

export type ToTrialWorker =
  /** adds mazes to those that wait; each is answered by a result */
  | {
      type: "try";
      job: number;
      program: ProgramDocument;
      mazes: TrialMazes;
      seeds: readonly number[];
    }
  /** drops the mazes that wait */
  | { type: "stop" }
  | { type: "record"; maze: MazeDocument; program: ProgramDocument; ticks: number };

export type FromTrialWorker =
  | { type: "result"; job: number; result: TrialResult }
  | { type: "recorded"; written: WrittenRun };
