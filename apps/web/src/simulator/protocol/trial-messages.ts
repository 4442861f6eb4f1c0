/** Requests to a worker that tries programs in other mazes, and its answers. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { WrittenRun } from "@corridor/recording";
import type { TrialMazes, TrialResult } from "../trial-worker/maze-trial.ts";

export type ToTrialWorker =
  /** queues mazes; each is answered by a result */
  | {
      type: "try";
      job: number;
      program: ProgramDocument;
      mazes: TrialMazes;
      seeds: readonly number[];
    }
  /** drops the queued mazes */
  | { type: "stop" }
  | { type: "record"; maze: MazeDocument; program: ProgramDocument; ticks: number };

export type FromTrialWorker =
  | { type: "result"; job: number; result: TrialResult }
  | { type: "recorded"; written: WrittenRun };
