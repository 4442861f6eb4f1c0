/**
 * What all cores share of a grading: the job, and a counter from which each takes its next pair. No
 * core waits for another, and none is left with a long rest.
 */
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import type { RunLimits } from "./run-limits.ts";
import { runProgram, type RunResult } from "./run-result.ts";

export interface GradeJob {
  mazes: MazeDocument[];
  programs: ProgramDocument[];
  limits: RunLimits;
}

export interface GradeShare {
  job: GradeJob;
  /** the next pair that nobody has taken yet: program * mazes + maze */
  next: Int32Array<SharedArrayBuffer>;
}

export interface GradedPair {
  pair: number;
  result: RunResult;
}

/** Runs pairs until none is left. */
export function gradeShare({ job, next }: GradeShare): GradedPair[] {
  const { mazes, programs, limits } = job;
  const graded: GradedPair[] = [];
  for (;;) {
    const pair = Atomics.add(next, 0, 1);
    const program = programs[Math.floor(pair / mazes.length)];
    const maze = mazes[pair % mazes.length];
    if (program === undefined || maze === undefined) return graded;
    graded.push({ pair, result: runProgram(maze, program, limits) });
  }
}
