/**
 * Selects the faster of two journals for each write. On a fast disk, waking a thread and waiting
 * for its answer takes longer than writing a few entries. Small batches are therefore written
 * synchronously. Large batches, and all batches while the disk is slow, go to the thread.
 */
import type { Journal, Written } from "./journal.ts";
import type { Entry, Compaction } from "./journal-writer.ts";

/**
 * Larger batches occur only under load. A small batch right after a large one usually has more
 * behind it.
 */
const FEW = 4;
/** A synchronous write blocks all other work for its duration. */
const SLOW_MS = 2;
/**
 * Slow writes in excess of fast ones before the thread takes over. A single slow write shows a busy
 * machine, which delays the thread too.
 */
const MANY_SLOW = 3;
/** Time after which synchronous writes are tried again. */
const TRY_AGAIN_MS = 10_000;

export class AdaptiveJournal implements Journal {
  readonly #own: Journal;
  readonly #thread: Journal;
  readonly #now: () => number;
  /** number of slow writes minus fast ones, at least 0 */
  #slow = 0;
  #slowUntil = -Infinity;
  /** number of entries in the previous write */
  #before = 0;

  /**
   * @param own writes before it returns
   * @param now ms of a monotonic clock
   */
  constructor(own: Journal, thread: Journal, now: () => number = () => performance.now()) {
    this.#own = own;
    this.#thread = thread;
    this.#now = now;
  }

  write(entries: readonly Entry[], compaction: Compaction | null, written: Written): void {
    const begun = this.#now();
    const isLittle = compaction === null && Math.max(entries.length, this.#before) <= FEW;
    this.#before = entries.length;
    const isOwn = isLittle && begun >= this.#slowUntil;
    (isOwn ? this.#own : this.#thread).write(entries, compaction, (...how) => {
      if (isOwn) this.#took(this.#now() - begun);
      written(...how);
    });
  }

  #took(ms: number): void {
    this.#slow = ms > SLOW_MS ? Math.min(this.#slow + 1, MANY_SLOW) : Math.max(this.#slow - 1, 0);
    if (this.#slow === MANY_SLOW) this.#slowUntil = this.#now() + TRY_AGAIN_MS;
  }

  async close(): Promise<void> {
    await this.#thread.close();
  }
}
