/** Runs a program in a generated maze without a page. */
import { generateMaze, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";
import type { TrialMazes, TrialOutcome, TrialResult } from "../protocol/trial-messages.ts";

/**
 * Simulated minutes for a program in a maze: about three times as long as following a wall takes.
 */
export function minutesFor(side: number): number {
  return Math.ceil((side * side) / 25);
}

export function mazeOf({ kind, side }: TrialMazes, seed: number, name = ""): MazeDocument {
  return generateMaze({ kind, columns: side, rows: side, seed, name });
}

/** A program works in a maze if it reaches the goal in time and without a bump. */
export function tryMaze(
  maze: MazeDocument,
  program: ProgramDocument,
  minutes: number,
): Pick<TrialResult, "outcome" | "tick"> {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const outcome = runUntilDecided(simulation, run, minutes * 60 * TICKS_PER_SECOND);
  return { outcome, tick: simulation.tick };
}

/** Its own function, so that the engine optimises the loop once for all mazes. */
function runUntilDecided(simulation: Simulation, run: ProgramRun, ticks: number): TrialOutcome {
  while (simulation.tick < ticks) {
    run.step();
    if (simulation.bumps > 0) return "bump";
    if (simulation.goalTick !== null) return "works";
  }
  return "time-limit";
}
