/**
 * Tells the relay which maze the robot is in, for those who look on: once a robot is connected, and again
 * when the maze has rested for half a second after a change.
 */
import type { MazeDocument } from "@corridor/maze";

const REST_MS = 500;
/** Pause before the relay is told again what it could not take. */
const AGAIN_MS = 3_000;

export interface MazeTellerPorts {
  /** monotonic milliseconds */
  now(): number;
  /** Gives the maze to the relay. @returns the status of its answer; rejects where none came */
  give(text: string): Promise<number>;
}

export class MazeTeller {
  readonly #ports: MazeTellerPorts;
  #maze: MazeDocument | null = null;
  #changedAt = Number.NEGATIVE_INFINITY;
  /** the relay has it, or will never take it */
  #told: string | null = null;
  #isTelling = false;
  #notBefore = Number.NEGATIVE_INFINITY;
  /** rises with each robot: what was told of an earlier one says nothing of this one */
  #robot = 0;

  constructor(ports: MazeTellerPorts) {
    this.#ports = ports;
  }

  /** Another robot, of which the relay knows nothing yet. */
  begin(): void {
    this.#robot += 1;
    this.#told = null;
    this.#maze = null;
    this.#isTelling = false;
    this.#notBefore = Number.NEGATIVE_INFINITY;
  }

  /** Is called with each report of the robot, at least once a second. */
  offer(maze: MazeDocument | null): void {
    if (maze === null) return;
    const now = this.#ports.now();
    if (maze !== this.#maze) {
      const isFirst = this.#maze === null;
      this.#maze = maze;
      this.#changedAt = isFirst ? now - REST_MS : now;
    }
    if (this.#isTelling || now < this.#notBefore || now - this.#changedAt < REST_MS) return;
    const text = JSON.stringify(maze);
    // From here on the same object is known to be told.
    this.#changedAt = Number.POSITIVE_INFINITY;
    if (text === this.#told) return;
    this.#tell(text);
  }

  #tell(text: string): void {
    const robot = this.#robot;
    this.#isTelling = true;
    const over = (isSettled: boolean): void => {
      if (robot !== this.#robot) return;
      this.#isTelling = false;
      if (isSettled) {
        this.#told = text;
        return;
      }
      const now = this.#ports.now();
      this.#notBefore = now + AGAIN_MS;
      if (this.#changedAt === Number.POSITIVE_INFINITY) this.#changedAt = now - REST_MS;
    };
    // What is too large, or not the robot's any more, is not said again and again.
    this.#ports.give(text).then(
      (status) => over(status < 500 && status !== 429),
      () => over(false),
    );
  }
}
