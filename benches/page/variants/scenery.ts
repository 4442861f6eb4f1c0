/** What every variant draws: one robot in one maze, its readings, and a trail of many points behind it. */
import { generateTree, type MazeDocument } from "@corridor/maze";
import { CompiledProgram, programPresets, type ProgramDocument } from "@corridor/program";
import type { Pose, SensorReadings } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";

/** Points of the trail when a measurement begins. */
export const TRAIL_POINTS = 5000;
/** Side of the stage in CSS pixels. */
export const STAGE_PX = 960;

/** A tree without goals, so that the program never ends. */
export function sceneryMaze(side: number): MazeDocument {
  return {
    ...generateTree({ columns: side, rows: side, seed: 1, name: `Tree ${side}` }),
    goals: [],
  };
}

export function sceneryProgram(): ProgramDocument {
  const preset = programPresets.find(({ id }) => id === "right-wall");
  if (preset === undefined) throw new Error("no right-wall program among the presets");
  return preset.program;
}

/** The state of one animation frame. */
export interface Shot {
  pose: Pose;
  sensors: SensorReadings;
  tick: number;
}

/** Runs the robot, one tick a frame. */
export class Scenery {
  readonly maze: MazeDocument;
  readonly #simulation: Simulation;
  readonly #run: ProgramRun;
  #corners: number[] = [];
  #heading = Number.NaN;

  constructor(side: number) {
    this.maze = sceneryMaze(side);
    this.#simulation = new Simulation(this.maze);
    this.#run = new ProgramRun(this.#simulation, new CompiledProgram(sceneryProgram()));
  }

  /** Runs until the trail has its points. @returns them, x and y by turns */
  runUp(): number[] {
    while (this.#corners.length < 2 * TRAIL_POINTS) this.#tick();
    return this.#corners;
  }

  get ticks(): number {
    return this.#simulation.tick;
  }

  step(): Shot {
    this.#tick();
    const { pose, sensors, tick } = this.#simulation.report();
    return { pose, sensors, tick };
  }

  #tick(): void {
    this.#run.step();
    const { x, y, heading } = this.#simulation.pose;
    // The robot turns on the spot: one corner for each time that it begins to.
    if (heading % 90 === 0 && heading !== this.#heading) this.#corners.push(x, y);
    if (heading % 90 === 0) this.#heading = heading;
  }
}
