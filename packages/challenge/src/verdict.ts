/** What a check of a challenge says: passed, or the first thing that failed, with its numbers. */
import type { Cell } from "@corridor/maze";
import type { LineRef, PlainAction, SensorReadings } from "@corridor/protocol";

/** Why an attempt does not pass. `needed` and `found` are counted in what stands behind each. */
export type FailureCode =
  /** somebody drives who may not; no numbers */
  | "driver"
  /** lines */
  | "too-many-lines"
  /** the line asks what the challenge does not allow; no numbers */
  | "condition-not-allowed"
  /** the line does what the challenge does not allow; no numbers */
  | "action-not-allowed"
  /** something was changed that had to stay as it was; no numbers */
  | "changed"
  /** bumps: more than the challenge allows */
  | "bump"
  /** open cells: so many were visited, and the goal was not among them in time */
  | "not-reached"
  /** open cells: so many were visited in time */
  | "not-visited"
  /** units: what the sensor read at the end; `needed` is the nearer bound */
  | "not-stopped"
  /** units driven in time */
  | "too-short";

/** When and on what readings the line decided that led to a bump. */
export interface Decision {
  tick: number;
  /** null where a command and no program moved the robot */
  action: PlainAction | null;
  /** units */
  readings: SensorReadings;
}

export interface Failure {
  code: FailureCode;
  /** index of the maze; null where the program failed before it ran */
  maze: number | null;
  tick: number | null;
  /** the line that is meant, or that decided at that tick; null where no program drove */
  line: LineRef | null;
  /** where the robot's centre was */
  place: Cell | null;
  needed: number | null;
  found: number | null;
  /** for "bump" only */
  decision: Decision | null;
}

/** How one maze went, up to the tick at which it was decided. */
export interface MazeOutcome {
  failure: Failure | null;
  ticks: number;
  bumps: number;
  visited: number;
  open: number;
  /** units */
  distance: number;
}

export interface Verdict {
  passed: boolean;
  /** the first thing that failed; null when it passed */
  failure: Failure | null;
  /** one for each maze; none where the program itself is not allowed */
  mazes: readonly MazeOutcome[];
}
