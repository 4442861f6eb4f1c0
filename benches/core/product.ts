/**
 * The product as it ships: simulation, compiled program and snapshots, through their public APIs.
 */
import type { MazeDocument } from "@corridor/maze";
import { CompiledProgram, type ProgramDocument } from "@corridor/program";
import type { RobotReport } from "@corridor/protocol";
import { ProgramRun, Simulation } from "@corridor/simulation";
import type { Variant } from "./variant.ts";

export class Product implements Variant {
  readonly #simulation: Simulation;
  readonly #run: ProgramRun;
  latest: RobotReport;

  constructor(maze: MazeDocument, program: ProgramDocument) {
    this.#simulation = new Simulation(maze);
    this.#run = new ProgramRun(this.#simulation, new CompiledProgram(program));
    this.latest = this.#simulation.report();
  }

  get cell(): number {
    return this.#simulation.cell;
  }

  run(ticks: number): void {
    for (let i = 0; i < ticks; i++) {
      this.#run.step();
      this.latest = this.#simulation.report();
    }
  }
}
