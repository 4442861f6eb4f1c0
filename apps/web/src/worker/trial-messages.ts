/** What the page asks of a worker that tries programs in other mazes, and what it answers. */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { WrittenRun } from "@corridor/recording";
import type { TrialMazes, TrialResult } from "./maze-trial.ts";

export type ToTrialWorker =
  | { type: "try"; job: number; program: ProgramDocument; mazes: TrialMazes; seed: number }
  | { type: "record"; maze: MazeDocument; program: ProgramDocument; ticks: number };

export type FromTrialWorker =
  | { type: "result"; job: number; result: TrialResult }
  | { type: "recorded"; written: WrittenRun };
