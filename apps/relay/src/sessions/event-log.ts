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
  /** oldest first, without holes */
  #kept: { event: StateEvent; at: number }[] = [];
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
    const event: StateEvent = { n: this.#n, record };
    this.#kept.push({ event, at: this.#clock.now() });
    if (this.#kept.length > MAX_KEPT_EVENTS) this.#kept.shift();
    return event;
  }

  /** States may have come that nobody here heard of: whoever reads is told of a gap. */
  lose(): void {
    this.#n += 1;
    this.#kept = [];
  }

  /** Lets go of what is too old. */
  forgetOld(): void {
    const oldest = this.#clock.now() - KEPT_EVENTS_MS;
    if ((this.#kept[0]?.at ?? oldest) >= oldest) return;
    const first = this.#kept.findIndex(({ at }) => at >= oldest);
    this.#kept = first < 0 ? [] : this.#kept.slice(first);
  }

  /** The events after `n`, in order; null when some of them are not kept. */
  after(n: number): StateEvent[] | null {
    const missed = this.#n - n;
    if (missed < 0 || missed > this.#kept.length) return null;
    return missed === 0 ? [] : this.#kept.slice(-missed).map(({ event }) => event);
  }

  /** The number in a `since`; null when it belongs to another stream. */
  numberOf(since: string): number | null {
    const dash = since.lastIndexOf("-");
    return since.slice(0, dash) === this.stream ? Number(since.slice(dash + 1)) : null;
  }
}
