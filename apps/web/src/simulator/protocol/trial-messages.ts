/** Trials of a program in generated mazes, and their results. */
import type { MazeDocument, MazeKind } from "@corridor/maze";

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
