/** What every variant of the comparison does, so that one loop can time them all. */
import type { RobotReport } from "@corridor/protocol";

export interface Contender {
  /** Runs whole ticks: sensors, rules, motion, physics, and a snapshot object at the end of each. */
  run(ticks: number): void;
  /** the newest snapshot; kept where all can see it, so that V8 cannot drop the object as unused */
  latest: RobotReport;
  /** the cell under the robot's centre, as `row * columns + column` */
  readonly cell: number;
}
