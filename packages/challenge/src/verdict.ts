/** Result of checking a challenge: passed, or the first failure with its numbers. */
import type { Cell } from "@corridor/maze";
import type { LineRef, PlainAction, SensorReadings } from "@corridor/protocol";

/**
 * Reason for a failed attempt. Each comment states the meaning and unit of `needed` and `found`.
 */
export type FailureCode =
  /** a driver that the challenge does not allow; no numbers */
  | "driver"
  /** number of lines */
  | "too-many-lines"
  /** a condition that the challenge does not allow; no numbers */
  | "condition-not-allowed"
  /** an action that the challenge does not allow; no numbers */
  | "action-not-allowed"
  /** a part of the given program changed that the challenge does not allow to change; no numbers */
  | "changed"
  /** number of bumps, more than the challenge allows */
  | "bump"
  /** number of open cells visited before the timeout, without the goal */
  | "not-reached"
  /** number of open cells visited before the timeout */
  | "not-visited"
  /** sensor reading at the timeout, in units; `needed` is the nearer bound */
  | "not-stopped"
  /** distance driven before the timeout, in units */
  | "too-short";

/** The decision that led to a bump. */
export interface Decision {
  tick: number;
  /** null if a command moved the robot, not a program */
  action: PlainAction | null;
  /** readings on which the line decided, in units */
  readings: SensorReadings;
}

export interface Failure {
  code: FailureCode;
  /** index of the given maze; null if the attempt failed before it ran, or in an unseen maze */
  maze: number | null;
  tick: number | null;
  /** the violating line, or the line that decided at that tick; null if no program drove */
  line: LineRef | null;
  /** the cell under the robot's centre */
  place: Cell | null;
  needed: number | null;
  found: number | null;
  /** set for "bump" only */
  decision: Decision | null;
}

/** Result of one maze, up to the tick at which the goal was met or the attempt failed. */
export interface MazeOutcome {
  failure: Failure | null;
  ticks: number;
  bumps: number;
  visited: number;
  open: number;
  /** distance driven, in units */
  distance: number;
}

export interface Verdict {
  passed: boolean;
  /** the first failure; null if the attempt passed */
  failure: Failure | null;
  /** one result per maze; empty if the attempt itself is not allowed */
  mazes: readonly MazeOutcome[];
}
