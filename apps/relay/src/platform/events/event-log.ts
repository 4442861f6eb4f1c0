/**
 * Newest numbered events of a robot or a class, for readers that reconnect. The log is held in
 * memory. Readers of another stream receive a gap.
 */
import { EVENT_RETENTION_MS, MAX_STORED_EVENTS, sinceOf } from "@corridor/protocol";
import type { Clock } from "../time/clock.ts";
import { mintStream } from "../keys.ts";
import { PackedTexts } from "./packed-texts.ts";

/** A thousand usual events need a tenth. Commands with many conditions need more. */
const MAX_STORED_BYTES = 2_097_152;

/** The text of an event in the log. */
export interface Packing<T> {
  pack(record: T): string;
  unpack(text: string): T;
}

export interface NumberedEvent<T> {
  n: number;
  record: T;
}

/** Where the numbers of a log start: in a new stream at 0, or where an earlier log ended. */
export interface LogStart {
  stream: string;
  n: number;
}

export class EventLog<T> {
  readonly stream: string;
  readonly #clock: Clock;
  /**
   * Records from oldest to newest, without gaps, and their times. The records are packed, because
   * few are ever read again. As objects, a thousand for each of thousands of robots would fill most
   * of the heap.
   */
  readonly #stored = new PackedTexts();
  #times: number[] = [];
  readonly #packing: Packing<T>;
  #n: number;

  constructor(clock: Clock, packing: Packing<T>, start: LogStart = { stream: mintStream(), n: 0 }) {
    this.#clock = clock;
    this.#packing = packing;
    this.stream = start.stream;
    this.#n = start.n;
  }

  /** Number of the newest event; 0 before the first. */
  get n(): number {
    return this.#n;
  }

  /** Resume position of a reader that has received all events. */
  get since(): string {
    return sinceOf(this.stream, this.#n);
  }

  add(record: T): NumberedEvent<T> {
    this.#n += 1;
    this.#stored.push(this.#packing.pack(record));
    this.#times.push(this.#clock.now());
    while (this.#stored.length > MAX_STORED_EVENTS || this.#stored.size > MAX_STORED_BYTES) {
      this.#stored.shift(1);
      this.#times.shift();
    }
    return { n: this.#n, record };
  }

  /** Events may have been missed, so all readers of earlier positions must receive a gap. */
  lose(): void {
    this.skipTo(this.#n + 1);
  }

  /** The events up to this number are not known. */
  skipTo(n: number): void {
    this.#n = n;
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
  after(n: number): Iterable<NumberedEvent<T>> | null {
    return this.hasAfter(n) ? this.#from(n + 1, this.#n) : null;
  }

  /** The number in a `since` value; null if it belongs to another stream. */
  numberOf(since: string): number | null {
    const dash = since.lastIndexOf("-");
    return since.slice(0, dash) === this.stream ? Number(since.slice(dash + 1)) : null;
  }

  *#from(first: number, last: number): Iterable<NumberedEvent<T>> {
    for (let n = first; n <= last; n++) {
      const at = n - this.#n + this.#stored.length - 1;
      if (at >= 0) yield { n, record: this.#packing.unpack(this.#stored.at(at)) };
    }
  }

  #remove(count: number): void {
    this.#stored.shift(count);
    this.#times.splice(0, count);
  }
}
