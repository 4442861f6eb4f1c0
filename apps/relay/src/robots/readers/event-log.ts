/**
 * Newest states of a robot's commands, numbered, for readers that reconnect. The log is held in
 * memory. After a restart the numbers start again in another stream, so readers of the old stream
 * receive a gap.
 */
import {
  EVENT_RETENTION_MS,
  MAX_STORED_EVENTS,
  sinceOf,
  type CommandRecord,
  type StateEvent,
} from "@corridor/protocol";
import type { Clock } from "../../platform/time/clock.ts";
import { mintStream } from "../../platform/keys.ts";
import { PackedTexts } from "./packed-texts.ts";

export class EventLog {
  readonly stream = mintStream();
  readonly #clock: Clock;
  /**
   * Records from oldest to newest, without gaps, and their times. The records are packed, because
   * few are ever read again. As objects, a thousand for each of thousands of robots would fill most
   * of the heap.
   */
  readonly #stored = new PackedTexts();
  #times: number[] = [];
  #n = 0;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** Number of the newest event; 0 before the first. */
  get n(): number {
    return this.#n;
  }

  /** Resume position of a reader that has received all events. */
  get since(): string {
    return sinceOf(this.stream, this.#n);
  }

  add(record: CommandRecord): StateEvent {
    this.#n += 1;
    this.#stored.push(packed(record));
    this.#times.push(this.#clock.now());
    if (this.#stored.length > MAX_STORED_EVENTS) {
      this.#stored.shift(1);
      this.#times.shift();
    }
    return { n: this.#n, record };
  }

  /** States may have been missed, so all readers of earlier positions must receive a gap. */
  lose(): void {
    this.#n += 1;
    this.#remove(this.#stored.length);
  }

  /** Deletes events that exceed the retention time. */
  deleteOld(): void {
    const oldest = this.#clock.now() - EVENT_RETENTION_MS;
    if ((this.#times[0] ?? oldest) >= oldest) return;
    const first = this.#times.findIndex((at) => at >= oldest);
    this.#remove(first < 0 ? this.#stored.length : first);
  }

  /** Whether all events after `n` are stored. */
  hasAfter(n: number): boolean {
    const missed = this.#n - n;
    return missed >= 0 && missed <= this.#stored.length;
  }

  /**
   * Current events after `n`, in order; null if some of them are no longer stored. The iterator
   * reads each event when it reaches it, and skips those that are deleted by then.
   */
  after(n: number): Iterable<StateEvent> | null {
    return this.hasAfter(n) ? this.#from(n + 1, this.#n) : null;
  }

  /** The number in a `since` value; null if it belongs to another stream. */
  numberOf(since: string): number | null {
    const dash = since.lastIndexOf("-");
    return since.slice(0, dash) === this.stream ? Number(since.slice(dash + 1)) : null;
  }

  *#from(first: number, last: number): Iterable<StateEvent> {
    for (let n = first; n <= last; n++) {
      const at = n - this.#n + this.#stored.length - 1;
      if (at >= 0) yield { n, record: unpacked(this.#stored.at(at)) };
    }
  }

  #remove(count: number): void {
    this.#stored.shift(count);
    this.#times.splice(0, count);
  }
}

/** A record without its field names, which would be half of the text. */
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
