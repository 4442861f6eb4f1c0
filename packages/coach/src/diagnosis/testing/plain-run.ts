/**
 * A run as a list of ticks, to check the claims of a diagnosis. It uses only the simulation and
 * shares no code with the diagnosis.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { LineRef, PlainAction, SensorReadings } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";

export interface PlainTick {
  /** before the tick */
  readings: SensorReadings;
  /** the deciding line; null during a manoeuvre */
  line: LineRef | null;
  action: PlainAction | null;
  /** after the tick */
  bumps: number;
  x: number;
  y: number;
}

export function plainRun(maze: MazeDocument, program: ProgramDocument, ticks: number): PlainTick[] {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(program));
  return Array.from({ length: ticks }, () => {
    const readings = simulation.report().sensors;
    const isDecision = run.decide() !== null;
    const line = isDecision ? run.line : null;
    run.step();
    const { bumps, x, y } = simulation;
    return { readings, line, action: line === null ? null : actionIn(program, line), bumps, x, y };
  });
}

/**
 * Runs one program until a tick, then another.
 * @returns ticks of bumps and goal, and visited squares
 */
export function switchedRun(
  maze: MazeDocument,
  [first, second]: readonly [ProgramDocument, ProgramDocument],
  at: number,
  ticks: number,
): { bumps: number[]; goal: number | null; squares: ReadonlySet<string> } {
  const simulation = new Simulation(maze);
  const run = new ProgramRun(simulation, new CompiledProgram(first));
  const bumps: number[] = [];
  const squares = new Set<string>();
  while (simulation.tick < ticks) {
    if (simulation.tick === at) run.reconsider(new CompiledProgram(second));
    const before = simulation.bumps;
    run.step();
    squares.add(squareOf(simulation));
    if (simulation.bumps > before) bumps.push(simulation.tick);
  }
  return { bumps, goal: simulation.goalTick, squares };
}

export function squareOf({ x, y }: Pick<PlainTick, "x" | "y">): string {
  return `${Math.floor(x / 100)},${Math.floor(y / 100)}`;
}

export function actionIn({ rules, default: otherwise }: ProgramDocument, line: LineRef) {
  return line === "default" ? otherwise : (rules[line]?.do ?? otherwise);
}
