/** The units of grading programs in maze files: one run of a program in a maze. */
import { diagnoseFreePlay, type Diagnosis } from "@corridor/coach";
import type { MazeDocument } from "@corridor/maze";
import type { ProgramDocument } from "@corridor/program";
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { Simulation } from "@corridor/simulation";
import type { RunLimits } from "./run-limits.ts";
import { runProgram, type RunResult } from "./run-result.ts";
import type { Units } from "./work-share.ts";

export interface RunJob {
  mazes: MazeDocument[];
  programs: ProgramDocument[];
  limits: RunLimits;
  /** whether to diagnose failed runs */
  why: boolean;
}

export interface Run {
  /** indices in the job */
  program: number;
  maze: number;
  result: RunResult;
  /** null if the run did not fail, or if `RunJob.why` is false */
  diagnosis: Diagnosis | null;
}

/**
 * The units of a job: all programs in the first maze, then in the next maze. Alternates between the
 * programs, so that V8 has seen the types of all programs before it optimises the loop.
 */
export function unitsOfRuns({ mazes, programs, limits, why }: RunJob): Units<Run> {
  return {
    count: programs.length * mazes.length,
    run: (unit) => {
      const at = { program: unit % programs.length, maze: Math.floor(unit / programs.length) };
      const program = programs[at.program];
      const maze = mazes[at.maze];
      if (program === undefined || maze === undefined) throw new RangeError(`no unit ${unit}`);
      const diagnosis = why ? diagnosisOf(maze, program, limits) : null;
      return { ...at, result: runProgram(maze, program, limits), diagnosis };
    },
  };
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
