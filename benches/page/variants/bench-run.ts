/** The run that every variant draws: one robot in one maze, its readings, and a long trail. */
import { generateTree, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, programPresets, type ProgramDocument } from "@corridor/program";
import type { Pose, SensorReadings } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";

/** Points of the trail at the start of a measurement. */
export const TRAIL_POINTS = 5000;
/** Side of the stage in CSS pixels. */
export const STAGE_PX = 960;

/** A tree without goals, so that the program never ends. */
export function benchMaze(side: number): MazeDocument {
  return {
    ...generateTree({ columns: side, rows: side, seed: 1, name: `Tree ${side}` }),
    goals: [],
  };
}

export function benchProgram(): ProgramDocument {
  const preset = programPresets.find(({ id }) => id === "right-wall");
  if (preset === undefined) throw new Error("no right-wall program among the presets");
  return preset.program;
}

/** The state of the robot in one animation frame. */
export interface RunFrame {
  pose: Pose;
  sensors: SensorReadings;
  tick: number;
}

/** Runs the robot, one tick per frame. */
export class BenchRun {
  readonly maze: MazeDocument;
  readonly #simulation: Simulation;
  readonly #run: ProgramRun;
  #corners: number[] = [];
  #heading = Number.NaN;

  constructor(side: number) {
    this.maze = benchMaze(side);
    this.#simulation = new Simulation(this.maze);
    this.#run = new ProgramRun(this.#simulation, new CompiledProgram(benchProgram()));
  }

  /** Drives until the trail has all its points. @returns the trail, alternating x and y */
  driveTrail(): number[] {
    while (this.#corners.length < 2 * TRAIL_POINTS) this.#tick();
    return this.#corners;
  }

  get ticks(): number {
    return this.#simulation.tick;
  }

  step(): RunFrame {
    this.#tick();
    const { pose, sensors, tick } = this.#simulation.report();
    return { pose, sensors, tick };
  }

  #tick(): void {
    this.#run.step();
    const { x, y, heading } = this.#simulation.pose;
    // The robot turns on the spot, so the trail gets one corner per turn.
    if (heading % 90 === 0 && heading !== this.#heading) this.#corners.push(x, y);
    if (heading % 90 === 0) this.#heading = heading;
  }
}
