/**
 * A scenario of `npm run test:faults`: injects a fault into the real service and checks the
 * outcome.
 */
import type { Goal } from "../../benches/core/goals.ts";

export interface ScenarioContext {
  /** whether this is the long run, for a release */
  isLong: boolean;
  /** seed of the scenario's random source */
  seed: number;
  /** an empty folder, removed after the scenario */
  folder: string;
  /** Prints a line. */
  log(line: string): void;
  /**
   * Registers a cleanup that runs after the scenario, also if it fails. The last one runs first.
   */
  onCleanup(clean: () => unknown): void;
}

export interface Scenario {
  /** title; words on the command line select scenarios by it */
  title: string;
  /** describes the scenario for the report */
  describe(isLong: boolean): string;
  /** Runs the scenario. @returns the goals that must hold, with their measured values */
  run(context: ScenarioContext): Promise<readonly Goal[]>;
}
