/**
 * The newest states of a robot's commands, numbered, for readers that come back. Kept in memory: after
 * a restart the numbers begin again in another stream, so that who asks for the old ones is told of the
 * gap and never takes silence for "nothing happened".
 */
import {
  KEPT_EVENTS_MS,
  MAX_KEPT_EVENTS,
  sinceOf,
  type CommandRecord,
  type StateEvent,
} from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { mintStream } from "../keys.ts";

export class EventLog {
  readonly stream = mintStream();
  readonly #clock: Clock;
  /**
   * Oldest first, without holes: no more than the records themselves, and when each came. A thousand of each of
   * thousands of robots are most of what the relay has in memory, and goes through whenever it looks for garbage.
   */
  #records: CommandRecord[] = [];
  #times: number[] = [];
  #n = 0;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** Number of the newest event; 0 before the first. */
  get n(): number {
    return this.#n;
  }

  /** What a reader that knows everything up to here comes back with. */
  get since(): string {
    return sinceOf(this.stream, this.#n);
  }

  add(record: CommandRecord): StateEvent {
    this.#n += 1;
    this.#records.push(record);
    this.#times.push(this.#clock.now());
    if (this.#records.length > MAX_KEPT_EVENTS) {
      this.#records.shift();
      this.#times.shift();
    }
    return { n: this.#n, record };
  }

  /** States may have come that nobody here heard of: whoever reads is told of a gap. */
  lose(): void {
    this.#n += 1;
    this.#forget(this.#records.length);
  }

  /** Lets go of what is too old. */
  forgetOld(): void {
    const oldest = this.#clock.now() - KEPT_EVENTS_MS;
    if ((this.#times[0] ?? oldest) >= oldest) return;
    const first = this.#times.findIndex((at) => at >= oldest);
    this.#forget(first < 0 ? this.#records.length : first);
  }

  /** The events after `n`, in order; null when some of them are not kept. */
  after(n: number): StateEvent[] | null {
    const missed = this.#n - n;
    if (missed < 0 || missed > this.#records.length) return null;
    const first = this.#records.length - missed;
    return this.#records.slice(first).map((record, at) => ({ n: n + 1 + at, record }));
  }

  #forget(count: number): void {
    this.#records.splice(0, count);
    this.#times.splice(0, count);
  }

  /** The number in a `since`; null when it belongs to another stream. */
  numberOf(since: string): number | null {
    const dash = since.lastIndexOf("-");
    return since.slice(0, dash) === this.stream ? Number(since.slice(dash + 1)) : null;
  }
}
