/**
 * Measures the overhead of a check of a task over the ticks themselves: the same program in the same
 * maze, in runs of two simulated minutes that never reach a goal.
 */
import { checkMaze } from "@corridor/challenge";
import { generateTree } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import { TICKS_PER_SECOND } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";
import { measureRounds, timesSlower, type Timed } from "./measure.ts";
import { taskIn } from "./task.ts";

const SIDE = 33;
const RUN_TICKS = 120 * TICKS_PER_SECOND;
const WARM_UP_TICKS = 50 * RUN_TICKS;
const ROUNDS = 41;
const ROUND_MS = 25;

const maze = { ...generateTree({ columns: SIDE, rows: SIDE, seed: 1, name: "Tree" }), goals: [] };

/** A task that every program fails, at its time limit. */
const { task } = taskIn(maze, RUN_TICKS / TICKS_PER_SECOND);

/** @returns ticks per second of a check, relative to those of a bare simulation */
export function measureChecking(program: ProgramDocument): number {
  const timed: Timed[] = [
    { run: inRuns((ticks) => runBare(program, ticks)), roundMs: ROUND_MS },
    { run: inRuns((ticks) => check(program, ticks)), roundMs: ROUND_MS },
  ];
  // Each run builds its maze, so rounds of few ticks would measure that instead of the ticks.
  for (const { run } of timed) run(WARM_UP_TICKS);
  const [raw = [], checked = []] = measureRounds(timed, ROUNDS);
  return timesSlower(raw, checked);
}

/** Divides ticks into runs of at most `RUN_TICKS`. */
function inRuns(run: (ticks: number) => void): (ticks: number) => void {
  return (ticks) => {
    for (let left = ticks; left > 0; left -= RUN_TICKS) run(Math.min(left, RUN_TICKS));
  };
}

function runBare(program: ProgramDocument, ticks: number): void {
  runTicks(new ProgramRun(new Simulation(maze), new CompiledProgram(program)), ticks);
}

/** Separate, so that V8 keeps the optimised loop from one run to the next. */
function runTicks(run: ProgramRun, ticks: number): void {
  for (let tick = 0; tick < ticks; tick++) run.step();
}

/** @throws Error if the check does not run all ticks */
function check(program: ProgramDocument, ticks: number): void {
  const seconds = ticks / TICKS_PER_SECOND;
  const outcome = checkMaze({ ...task, checks: { bumps: null, seconds } }, maze, program, 0);
  if (Math.abs(outcome.ticks - ticks) > 1) throw new Error(`the check ran ${outcome.ticks} ticks`);
}
