/**
 * Runs a program in the simulation and lists all ticks. Tests check the sentences of a diagnosis
 * against the list, so it shares no code with the diagnosis.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { LineRef, PlainAction, SensorReadings } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";

export interface PlainMoment {
  /** readings before the tick, in units */
  sensors: SensorReadings;
  x: number;
  y: number;
  heading: number;
  /** the line that decided on this tick; null while a manoeuvre runs */
  line: LineRef | null;
  action: PlainAction | null;
  /** bumps before the tick */
  bumps: number;
}

/** Returns the ticks from 0 to `ticks`. The last entry is the final state, without a decision. */
export function plainDrive(
  maze: MazeDocument,
  program: ProgramDocument,
  ticks: number,
): PlainMoment[] {
  const robot = new Simulation(maze);
  const run = new ProgramRun(robot, new CompiledProgram(program));
  return Array.from({ length: ticks + 1 }, (_, tick) => {
    const { sensors } = robot.report();
    const { x, y, heading } = robot.pose;
    const { bumps } = robot;
    const line = run.decide() === null || tick === ticks ? null : run.line;
    const action = line === null ? null : actionOf(program, line);
    run.step();
    return { sensors, x, y, heading, line, action, bumps };
  });
}

function actionOf({ rules, default: otherwise }: ProgramDocument, line: LineRef): PlainAction {
  return line === "default" ? otherwise : (rules[line]?.do ?? otherwise);
}
