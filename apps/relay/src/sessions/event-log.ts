/**
 * The newest states of a robot's commands, numbered, for readers that come back. Kept in memory: after
 * a restart the numbers begin again in another stream, so that who asks for the old ones is told of the
 * gap and never takes silence for "nothing happened".
 */
import {
  EVENT_RETENTION_MS,
  MAX_STORED_EVENTS,
  sinceOf,
  type CommandRecord,
  type StateEvent,
} from "@corridor/protocol";
import type { Clock } from "../clock.ts";
import { mintStream } from "../keys.ts";
import { PackedTexts } from "./packed-texts.ts";

export class EventLog {
  readonly stream = mintStream();
  readonly #clock: Clock;
  /**
   * Oldest first, without holes, and when each came. Few are ever read again, and a thousand of each of thousands of
   * robots would be most of the objects that the relay has.
   */
  readonly #kept = new PackedTexts();
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
    this.#kept.push(packed(record));
    this.#times.push(this.#clock.now());
    if (this.#kept.length > MAX_STORED_EVENTS) {
      this.#kept.shift(1);
      this.#times.shift();
    }
    return { n: this.#n, record };
  }

  /** States may have come that nobody here heard of: whoever reads is told of a gap. */
  lose(): void {
    this.#n += 1;
    this.#forget(this.#kept.length);
  }

  /** Lets go of what is too old. */
  forgetOld(): void {
    const oldest = this.#clock.now() - EVENT_RETENTION_MS;
    if ((this.#times[0] ?? oldest) >= oldest) return;
    const first = this.#times.findIndex((at) => at >= oldest);
    this.#forget(first < 0 ? this.#kept.length : first);
  }

  /** Whether all events after `n` are kept. */
  hasAfter(n: number): boolean {
    const missed = this.#n - n;
    return missed >= 0 && missed <= this.#kept.length;
  }

  /**
   * The events after `n` that there are now, in order, each read when it is its turn: those that are not kept any more by
   * then are left out. Null when some of them are not kept now.
   */
  after(n: number): Iterable<StateEvent> | null {
    return this.hasAfter(n) ? this.#from(n + 1, this.#n) : null;
  }

  /** The number in a `since`; null when it belongs to another stream. */
  numberOf(since: string): number | null {
    const dash = since.lastIndexOf("-");
    return since.slice(0, dash) === this.stream ? Number(since.slice(dash + 1)) : null;
  }

  *#from(first: number, last: number): Iterable<StateEvent> {
    for (let n = first; n <= last; n++) {
      const at = n - this.#n + this.#kept.length - 1;
      if (at >= 0) yield { n, record: unpacked(this.#kept.at(at)) };
    }
  }

  #forget(count: number): void {
    this.#kept.shift(count);
    this.#times.splice(0, count);
  }
}

/** What a record says, without the names of its fields, which would be half of it. */
type Packed = [
  seq: CommandRecord["seq"],
  key: CommandRecord["key"],
  command: CommandRecord["command"],
  state: CommandRecord["state"],
  reason: CommandRecord["reason"],
  acceptedAt: CommandRecord["acceptedAt"],
  pose: CommandRecord["pose"],
  distance: CommandRecord["distance"],
  duplicate: CommandRecord["duplicate"],
];

function packed(record: CommandRecord): string {
  const { seq, key, command, state, reason, acceptedAt, pose, distance, duplicate } = record;
  const all: Packed = [seq, key, command, state, reason, acceptedAt, pose, distance, duplicate];
  return JSON.stringify(all);
}

function unpacked(text: string): CommandRecord {
  const all = JSON.parse(text) as Packed;
  const [seq, key, command, state, reason, acceptedAt, pose, distance, duplicate] = all;
  const { action } = command;
  return { seq, key, action, command, state, reason, acceptedAt, pose, distance, duplicate };
}
