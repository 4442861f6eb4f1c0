/**
 * Publishes the robot's maze to the relay, for viewers: once a robot is connected, and again half a
 * second after the last change.
 */
import type { MazeDocument } from "@corridor/maze";

const REST_MS = 500;
/** Delay before a failed request is repeated. */
const RETRY_MS = 3_000;

export interface MazePublisherPorts {
  /** monotonic milliseconds */
  now(): number;
  /**
   * Sends the maze to the relay.
   * @returns the status of the answer; rejects without one
   */
  put(text: string): Promise<number>;
}

export class MazePublisher {
  readonly #ports: MazePublisherPorts;
  #maze: MazeDocument | null = null;
  #changedAt = Number.NEGATIVE_INFINITY;
  /** the maze that the relay has, or will never accept */
  #published: string | null = null;
  #isPublishing = false;
  #notBefore = Number.NEGATIVE_INFINITY;
  /** increases with each robot: requests for an earlier one have no meaning for this one */
  #robot = 0;

  constructor(ports: MazePublisherPorts) {
    this.#ports = ports;
  }

  /** Starts with another robot, which the relay does not know yet. */
  begin(): void {
    this.#robot += 1;
    this.#published = null;
    this.#maze = null;
    this.#isPublishing = false;
    this.#notBefore = Number.NEGATIVE_INFINITY;
  }

  /** Called with each report of the robot, at least once a second. */
  offer(maze: MazeDocument | null): void {
    if (maze === null) return;
    const now = this.#ports.now();
    if (maze !== this.#maze) {
      const isFirst = this.#maze === null;
      this.#maze = maze;
      this.#changedAt = isFirst ? now - REST_MS : now;
    }
    if (this.#isPublishing || now < this.#notBefore || now - this.#changedAt < REST_MS) return;
    const text = JSON.stringify(maze);
    // From here on the same object is known to be published.
    this.#changedAt = Number.POSITIVE_INFINITY;
    if (text === this.#published) return;
    this.#publish(text);
  }

  #publish(text: string): void {
    const robot = this.#robot;
    this.#isPublishing = true;
    const over = (isSettled: boolean): void => {
      if (robot !== this.#robot) return;
      this.#isPublishing = false;
      if (isSettled) {
        this.#published = text;
        return;
      }
      const now = this.#ports.now();
      this.#notBefore = now + RETRY_MS;
      if (this.#changedAt === Number.POSITIVE_INFINITY) this.#changedAt = now - REST_MS;
    };
    // A maze that is too large, or of another robot now, is not sent again.
    this.#ports.put(text).then(
      (status) => over(status < 500 && status !== 429),
      () => over(false),
    );
  }
}
