/** Requests to a worker that tries programs in other mazes, and its answers. */
import type { MazeDocument, MazeKind } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { WrittenRun } from "@corridor/recording";

/**
 * The mazes to try. A seed of `generateMaze` identifies a maze, so that anybody can generate it.
 */
export interface TrialMazes {
  kind: MazeKind;
  /** columns and rows, odd */
  side: number;
}

export type TrialOutcome = "works" | "bump" | "time-limit";

export interface TrialResult {
  seed: number;
  maze: MazeDocument;
  outcome: TrialOutcome;
  /** when the goal was reached, the robot bumped, or the time was over */
  tick: number;
}

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
