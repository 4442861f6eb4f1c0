/** Requests to the worker that checks bonus missions, and its answers. */
import type { Task } from "@corridor/challenge";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";

export type BonusQuestion =
  /** in how many mazes of the task the program reaches the goal */
  | { kind: "mazes"; task: Task; program: ProgramDocument }
  /** whether the program fails to reach the goal of this maze within so many seconds */
  | { kind: "defeat"; maze: MazeDocument; program: ProgramDocument; seconds: number }
  /** the trail of the first attempt that reaches its goal */
  | {
      kind: "trail";
      attempts: readonly { maze: MazeDocument; program: ProgramDocument }[];
      seconds: number;
    };

/** `seconds` and `ticks`: simulated time */
export type DefeatResult =
  | { state: "no-goal" }
  /** no path of open cells leads from the start to a goal */
  | { state: "no-path" }
  | { state: "reached"; ticks: number }
  | { state: "defeated"; seconds: number; squares: number };

export interface SolvedTrail {
  maze: MazeDocument;
  pose: { x: number; y: number; heading: number };
  /** x and y alternating, in units; ends at the robot */
  points: number[];
}

export interface BonusAnswers {
  /** the verdict contains one outcome per maze; none if the program is not allowed */
  mazes: { solved: number; all: number; ticks: number; failed: readonly number[] };
  defeat: DefeatResult;
  /** null if no attempt reaches its goal */
  trail: SolvedTrail | null;
}

export type BonusAnswer = {
  [Kind in keyof BonusAnswers]: { kind: Kind; value: BonusAnswers[Kind] };
}[keyof BonusAnswers];
