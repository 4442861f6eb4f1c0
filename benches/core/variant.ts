/** The interface of every benchmarked variant, so that one loop can time all of them. */
import type { RobotReport } from "@corridor/protocol";

export interface Variant {
  /**
   * Runs complete ticks: sensors, rules, motion, physics, and a snapshot object after each tick.
   */
  run(ticks: number): void;
  /** The latest snapshot; public, so that V8 cannot eliminate the object as unused. */
  latest: RobotReport;
  /** Index of the cell under the robot's centre: `row * columns + column`. */
  readonly cell: number;
}
