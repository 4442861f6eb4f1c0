/**
 * The times that go with a command, so that the robot never starts it late although the network delays it.
 *
 * `sentAt` shows the relay how much longer a message took than the quickest one of this connection. How long the
 * quickest one took the relay cannot see; it was at most the smallest round trip, so that is added to `age`. A
 * command may be thought older than it is, by the way back, and never younger.
 */
import { MAX_AGE_MS } from "@corridor/protocol";
import type { Clock } from "./platform.ts";

export class CommandTimes {
  readonly #clock: Clock;
  /** ms of the quickest message of this connection, there and back */
  #smallest = Infinity;
  /** when the oldest message was sent that is not answered yet; null: none */
  #askedAt: number | null = null;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** The hello of a new connection leaves; the relay measures by it alone. @returns its `sentAt` */
  begin(): number {
    this.#smallest = Infinity;
    this.#askedAt = this.#clock.now();
    return Math.floor(this.#askedAt);
  }

  /** The hello or a command was answered, or refused. */
  answered(): void {
    if (this.#askedAt === null) return;
    this.#smallest = Math.min(this.#smallest, this.#clock.now() - this.#askedAt);
    this.#askedAt = null;
  }

  /** A command leaves. @param triedAt when it did so for the first time */
  leaves(triedAt: number): { sentAt: number; age: number } {
    const now = this.#clock.now();
    // The answer may be to this try or to one before: the longer of the two is the safe one.
    this.#askedAt ??= now;
    const age = Math.min(MAX_AGE_MS, Math.ceil(now - triedAt + this.#smallest));
    return { sentAt: Math.floor(now), age };
  }
}
