/**
 * One run of a program in a maze, measured: what a teacher wants to know of it.
 */
import { countOpenCells, sizeOf, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { Pose } from "@corridor/protocol";
import { ProgramRun, Simulation, TICKS_PER_SECOND } from "@corridor/simulation";
import type { RunLimits } from "./run-limits.ts";

export interface RunResult {
  ticks: number;
  bumps: number;
  visitedCells: number;
  openCells: number;
  /** units driven */
  distance: number;
  /** null where the goal was not reached */
  goalTick: number | null;
  pose: Pose;
  /** decisions of the default and of each rule, in the order of the document */
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
 * The ticks, and a 1 for each cell that was visited. A function of its own, so that the engine's
 * optimised loop does not end with every run that it leaves.
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
