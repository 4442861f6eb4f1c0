/**
 * A program's run as a list of its ticks, from the simulation alone: what the sentences of a diagnosis are
 * read against. It shares no code with the diagnosis.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { LineRef, PlainAction, SensorReadings } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";

export interface PlainMoment {
  /** before the tick, in units */
  sensors: SensorReadings;
  x: number;
  y: number;
  heading: number;
  /** the line that decided for it; null where a manoeuvre ran */
  line: LineRef | null;
  action: PlainAction | null;
  /** bumps up to the beginning of the tick */
  bumps: number;
}

/** Every tick up to one, and the robot as it stands then, when no line has decided any more. */
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
