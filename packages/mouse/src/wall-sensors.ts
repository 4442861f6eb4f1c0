/**
 * Where walls are, as the robot reads them by its own sensors.
 *
 * The sensors look ahead, to the right, back and to the left. When the robot stands at an angle of 45
 * degrees, the readings from before it turned count, because it cannot drive in between: diagonally
 * there is always a corner of a post.
 */
import { sensorNames, type Snapshot } from "@corridor/protocol";
import type { MazeFrame } from "./maze-frame.ts";

export class WallSensors {
  readonly #frame: MazeFrame;
  /** cm by direction, clockwise quarters from the program's north */
  readonly #readings: [number, number, number, number] = [0, 0, 0, 0];

  constructor(frame: MazeFrame) {
    this.#frame = frame;
  }

  /** Stores the readings of a robot that stands. */
  observe({ pose, sensors }: Snapshot): void {
    const heading = this.#frame.eighthsOf(pose.heading);
    if (heading % 2 !== 0) return;
    for (const [turned, name] of sensorNames.entries()) {
      this.#readings[(heading / 2 + turned) % 4] = sensors[name];
    }
  }

  /**
   * How far the robot could drive in a direction.
   * @param turned eighths of a full turn clockwise from ahead
   */
  freeHalfSteps(robot: Snapshot, turned: number): number {
    this.observe(robot);
    const direction = (this.#frame.eighthsOf(robot.pose.heading) + turned) % 8;
    if (direction % 2 !== 0) return 0;
    const { x, y } = this.#frame.placeOf(robot.pose);
    const isBetweenPosts = (direction % 4 === 0 ? x : y) % 2 === 0;
    if (isBetweenPosts) return 0;
    return this.#frame.freeHalfSteps(this.#readings[direction / 2] ?? 0);
  }
}
