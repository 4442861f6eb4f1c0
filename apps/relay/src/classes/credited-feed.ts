/**
 * Sends the newest content to one reader: at most one message in an interval, and at most two that
 * the reader has not acknowledged. Newer content is merged with the content that waits.
 */
import type { Clock } from "../platform/time/clock.ts";
import { limits } from "../platform/limits/limits.ts";

export interface CreditedFeedParts<T> {
  clock: Clock;
  /** @returns the ms from the message that is sent now to the next one */
  readonly intervalMs: () => number;
  readonly merge: (waiting: T, newer: T) => T;
  readonly send: (seq: number, content: T) => void;
}

export class CreditedFeed<T> {
  readonly #parts: CreditedFeedParts<T>;
  #waiting: { content: T } | null = null;
  /** number of the last message that was sent, and of the last one that was acknowledged */
  #seq = 0;
  #seen = 0;
  #sentAt = -Infinity;
  #cancelTimer: (() => void) | null = null;
  #isClosed = false;

  constructor(parts: CreditedFeedParts<T>) {
    this.#parts = parts;
  }

  /** Sends the content now or later. */
  offer(newer: T): void {
    const waiting = this.#waiting;
    const content = waiting === null ? newer : this.#parts.merge(waiting.content, newer);
    this.#waiting = { content };
    this.#flush();
  }

  /** The reader has read everything up to this message. */
  seen(seq: number): void {
    this.#seen = Math.max(this.#seen, Math.min(seq, this.#seq));
    this.#flush();
  }

  /** The interval may be shorter than before. */
  intervalChanged(): void {
    this.#cancelTimer?.();
    this.#cancelTimer = null;
    this.#flush();
  }

  close(): void {
    this.#isClosed = true;
    this.#waiting = null;
    this.#cancelTimer?.();
  }

  #flush(): void {
    const { clock, intervalMs, send } = this.#parts;
    const hasCredit = this.#seq - this.#seen < limits.classCredit;
    if (this.#waiting === null || this.#isClosed || !hasCredit) return;
    const waitMs = this.#sentAt + intervalMs() - clock.now();
    if (waitMs > 0) {
      this.#cancelTimer ??= clock.after(waitMs, () => {
        this.#cancelTimer = null;
        this.#flush();
      });
      return;
    }
    const { content } = this.#waiting;
    this.#waiting = null;
    this.#sentAt = clock.now();
    this.#seq += 1;
    send(this.#seq, content);
  }
}
