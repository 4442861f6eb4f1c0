/**
 * Messages between a pool and its workers. A job consists of numbered units that any worker can run
 * in any order; each unit has one result.
 */
import type { Attempt, CheckJob, LessonTask, MazeOutcome } from "@corridor/challenge";
import type { Diagnosis } from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { WrittenRun } from "@corridor/recording";
import type { TrialMazes, TrialResult } from "./trial-messages.ts";

/** A run to record, from the start of the maze. */
export interface RunToRecord {
  maze: MazeDocument;
  attempt: Attempt;
  ticks: number;
}

/** A program to diagnose in a maze of a task. */
export interface AttemptToDiagnose {
  task: LessonTask;
  program: ProgramDocument;
  /** see `mazeOf` */
  maze: number;
  /** a task can hide from a student what caused a failure, but not from a teacher */
  reader: "student" | "teacher";
}

/** Programs to race in a maze of a task. */
export interface RaceToRun {
  task: LessonTask;
  maze: MazeDocument;
  programs: readonly ProgramDocument[];
}

/** How a robot drives in a race. */
export interface RacedRun {
  /** x, y and heading at every `TICKS_PER_POSE`th tick, and at the last one */
  poses: Float32Array;
  /** until it solved the task, or failed */
  ticks: number;
  isSolved: boolean;
}

/** Ten poses per second. */
export const TICKS_PER_POSE = 6;

export type PoolJob =
  /** unit n tries the program in the maze with the seed `first` + n */
  | { kind: "trial"; program: ProgramDocument; mazes: TrialMazes; first: number }
  /** units of `checkUnitAt` */
  | { kind: "check"; check: CheckJob }
  /** a unit for each run */
  | { kind: "record"; runs: readonly RunToRecord[] }
  /** a unit for each program */
  | { kind: "race"; race: RaceToRun }
  /** a unit for each attempt */
  | { kind: "diagnose"; attempts: readonly AttemptToDiagnose[] };

/** The result of a unit, by the kind of its job. */
export type PoolResult =
  | { kind: "trial"; trial: TrialResult }
  | { kind: "check"; outcome: MazeOutcome }
  | { kind: "record"; written: WrittenRun }
  | { kind: "race"; run: RacedRun }
  | { kind: "diagnose"; diagnosis: Diagnosis | null };

/** Units from `from` up to and without `to`. */
export interface UnitRange {
  from: number;
  to: number;
}

export type ToPoolWorker =
  /** replaces the job; its units follow */
  | { type: "begin"; id: number; job: PoolJob }
  /** queues units of the job */
  | ({ type: "units" } & UnitRange)
  /** drops the queued units */
  | { type: "stop" };

/** Results of a job, in the order in which the worker ran the units. */
export interface FromPoolWorker {
  /** id of the job */
  id: number;
  results: readonly { unit: number; result: PoolResult }[];
}

/** The part of `Worker` that a pool uses. */
export interface PoolPort {
  postMessage: (message: ToPoolWorker) => void;
  onmessage: ((event: MessageEvent<FromPoolWorker>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate: () => void;
}
