/**
 * One run of a program in a maze, measured: what a teacher wants to know of it.
 */
import { countOpenCells, sizeOf, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { Pose } from "@corridor/protocol";
import { ProgramRun, Simulation, TICKS_PER_SECOND } from "@corridor/simulation";

export const untils = ["time", "goal", "bump"] as const;
export type Until = (typeof untils)[number];

export interface RunLimits {
  /** simulated time after which the run ends in any case */
  seconds: number;
  /** what may end it earlier */
  until: Until;
}

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
  { seconds, until }: RunLimits,
): RunResult {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  const { columns, rows } = sizeOf(maze);
  const visited = new Uint8Array(columns * rows);
  visited[simulation.cell] = 1;
  const ticks = Math.round(seconds * TICKS_PER_SECOND);
  while (simulation.tick < ticks) {
    run.step();
    visited[simulation.cell] = 1;
    if (until === "goal" && simulation.goalTick !== null) break;
    if (until === "bump" && simulation.bumps > 0) break;
  }
  return {
    ticks: simulation.tick,
    bumps: simulation.bumps,
    visitedCells: visited.reduce((sum, each) => sum + each, 0),
    openCells: countOpenCells(maze),
    distance: simulation.distance,
    goalTick: simulation.goalTick,
    pose: simulation.pose,
    decisions: {
      default: run.decisions[0] ?? 0,
      rules: program.rules.map((_, rule) => run.decisions[rule + 1] ?? 0),
    },
  };
}
