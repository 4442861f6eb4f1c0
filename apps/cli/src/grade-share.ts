/**
 * What all cores share of a grading: the job, and a counter from which each takes its next pair. No
 * core waits for another, and none is left with a long rest.
 */
import { diagnoseFreePlay, type Diagnosis } from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { Simulation, TICKS_PER_SECOND } from "@corridor/simulation";
import type { RunLimits } from "./run-limits.ts";
import { runProgram, type RunResult } from "./run-result.ts";

export interface GradeJob {
  mazes: MazeDocument[];
  programs: ProgramDocument[];
  limits: RunLimits;
  /** whether to say why a run failed */
  why: boolean;
}

export interface GradeShare {
  job: GradeJob;
  /** how many pairs have been taken: all programs in one maze, then in the next */
  taken: Int32Array<SharedArrayBuffer>;
}

export interface GradedPair {
  /** program * mazes + maze */
  pair: number;
  result: RunResult;
  /** null where the run did not fail, or nobody asked */
  diagnosis: Diagnosis | null;
}

/**
 * Runs pairs until none is left. The programs take turns, so that the engine has seen all that they
 * do before it settles how to run the loop.
 */
export function gradeShare({ job, taken }: GradeShare): GradedPair[] {
  const { mazes, programs, limits, why } = job;
  const graded: GradedPair[] = [];
  for (;;) {
    const turn = Atomics.add(taken, 0, 1);
    const programIndex = turn % programs.length;
    const mazeIndex = Math.floor(turn / programs.length);
    const program = programs[programIndex];
    const maze = mazes[mazeIndex];
    if (program === undefined || maze === undefined) return graded;
    const pair = programIndex * mazes.length + mazeIndex;
    const diagnosis = why ? diagnosisOf(maze, program, limits) : null;
    graded.push({ pair, result: runProgram(maze, program, limits), diagnosis });
  }
}

/** The same as the page says of a run of this program alone. */
function diagnosisOf(
  maze: MazeDocument,
  program: ProgramDocument,
  { seconds }: RunLimits,
): Diagnosis | null {
  const state = new Simulation(maze).save();
  const until = Math.round(seconds * TICKS_PER_SECOND);
  return diagnoseFreePlay({ maze, program, state }, until);
}
