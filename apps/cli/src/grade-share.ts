/**
 * Distributes the runs of a grading over all cores. The threads share the job and a counter, from
 * which each thread claims its next pair of program and maze. All threads finish at about the same
 * time.
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
  /** whether to diagnose failed runs */
  why: boolean;
}

export interface GradeShare {
  job: GradeJob;
  /** Number of pairs claimed so far: all programs in the first maze, then in the next maze. */
  nextPair: Int32Array<SharedArrayBuffer>;
}

export interface GradedPair {
  /** index of the program * number of mazes + index of the maze */
  pair: number;
  result: RunResult;
  /** null if the run did not fail, or if `GradeJob.why` is false */
  diagnosis: Diagnosis | null;
}

/**
 * Runs pairs until none is left. Alternates between the programs, so that V8 has seen the types of
 * all programs before it optimises the loop.
 */
export function gradeShare({ job, nextPair }: GradeShare): GradedPair[] {
  const { mazes, programs, limits, why } = job;
  const graded: GradedPair[] = [];
  for (;;) {
    const next = Atomics.add(nextPair, 0, 1);
    const programIndex = next % programs.length;
    const mazeIndex = Math.floor(next / programs.length);
    const program = programs[programIndex];
    const maze = mazes[mazeIndex];
    if (program === undefined || maze === undefined) return graded;
    const pair = programIndex * mazes.length + mazeIndex;
    const diagnosis = why ? diagnosisOf(maze, program, limits) : null;
    graded.push({ pair, result: runProgram(maze, program, limits), diagnosis });
  }
}

/** The same diagnosis that the page shows for a run of this program. */
function diagnosisOf(
  maze: MazeDocument,
  program: ProgramDocument,
  { seconds }: RunLimits,
): Diagnosis | null {
  const state = new Simulation(maze).save();
  const until = Math.round(seconds * TICKS_PER_SECOND);
  return diagnoseFreePlay({ maze, program, state }, until);
}
