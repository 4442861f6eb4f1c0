/** Runs a program in a maze and measures the run. */
import { countOpenCells, sizeOf, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import { type Pose, TICKS_PER_SECOND } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";
import type { RunLimits } from "./run-limits.ts";

export interface RunResult {
  ticks: number;
  bumps: number;
  visitedCells: number;
  openCells: number;
  /** driven distance in units */
  distance: number;
  /** null if the goal was not reached */
  goalTick: number | null;
  pose: Pose;
  /** number of decisions of the default and of each rule, in the order of the document */
  decisions: { default: number; rules: number[] };
}

export function runProgram(
  maze: MazeDocument,
  program: ProgramDocument,
  limits: RunLimits,
): RunResult {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const { columns, rows } = sizeOf(maze);
  const visited = new Uint8Array(columns * rows);
  runTicks(simulation, run, visited, limits);
  const [byDefault = 0, ...byRules] = run.decisions;
  return {
    ticks: simulation.tick,
    bumps: simulation.bumps,
    visitedCells: visited.reduce((sum, each) => sum + each, 0),
    openCells: countOpenCells(maze),
    distance: simulation.distance,
    goalTick: simulation.goalTick,
    pose: simulation.pose,
    decisions: { default: byDefault, rules: byRules },
  };
}

/**
 * Runs the ticks and sets a 1 in `visited` for each visited cell. Separate from `runProgram` so
 * that V8 keeps the optimised loop from one run to the next.
 */
function runTicks(
  simulation: Simulation,
  run: ProgramRun,
  visited: Uint8Array,
  { seconds, until }: RunLimits,
): void {
  const ticks = Math.round(seconds * TICKS_PER_SECOND);
  visited[simulation.cell] = 1;
  while (simulation.tick < ticks) {
    run.step();
    visited[simulation.cell] = 1;
    if (until === "goal" && simulation.goalTick !== null) return;
    if (until === "bump" && simulation.bumps > 0) return;
  }
}
