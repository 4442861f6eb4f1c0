import { MAX_AGE_MS } from "@corridor/protocol";
import type { Clock } from "./platform.ts";

/**
 * Send times and ages of commands, so that the robot never starts a command late after a network
 * delay.
 *
 * By `sentAt` the relay computes how much longer a message took than the fastest one of this
 * connection. The fastest one took at most the shortest round trip, which this class adds to `age`.
 * The age may be too high, by up to the time of the response, and never too low.
 */
export class CommandTimes {
  readonly #clock: Clock;
  /** ms of the shortest round trip on this connection */
  #shortestRoundTrip = Infinity;
  /** send time of the oldest unanswered message; null: none */
  #sentAt: number | null = null;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** To be called when a new connection sends `hello`; restarts the measurement. @returns its `sentAt` */
  start(): number {
    this.#shortestRoundTrip = Infinity;
    this.#sentAt = this.#clock.now();
    return Math.floor(this.#sentAt);
  }

  /** To be called for the response to `hello` or a command. */
  answered(): void {
    if (this.#sentAt === null) return;
    this.#shortestRoundTrip = Math.min(this.#shortestRoundTrip, this.#clock.now() - this.#sentAt);
    this.#sentAt = null;
  }

  /** The times of a command that is sent now. @param firstSentAt time of the first attempt */
  next(firstSentAt: number): { sentAt: number; age: number } {
    const now = this.#clock.now();
    // The response may be to an earlier attempt: the longer of both times is safe.
    this.#sentAt ??= now;
    const age = Math.min(MAX_AGE_MS, Math.ceil(now - firstSentAt + this.#shortestRoundTrip));
    return { sentAt: Math.floor(now), age };
  }
}
