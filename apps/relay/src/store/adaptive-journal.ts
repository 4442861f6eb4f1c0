/**
 * The shorter of two ways to the disk. To hand entries to a thread and be told takes longer than to write a few of
 * them, where the disk is quick: both threads have to be woken. So few are written at once by whoever calls, and many,
 * or any as long as the disk is slow, by the thread.
 */
import type { Journal, Told } from "./journal.ts";
import type { Entry, Tidying } from "./journal-writer.ts";

/** More come together only where much is going on; few right behind these have more behind them. */
const FEW = 4;
/** Whoever else is served meanwhile waits as long. */
const SLOW_MS = 2;
/** So many more slow writes than quick ones: one alone is that of a busy machine, which the thread would wait for as well. */
const MANY_SLOW = 3;
/** After so long it is tried again whether the disk is quick. */
const TRY_AGAIN_MS = 10_000;

export class AdaptiveJournal implements Journal {
  readonly #own: Journal;
  readonly #thread: Journal;
  readonly #now: () => number;
  /** slow writes, less the quick ones since */
  #slow = 0;
  #slowUntil = -Infinity;
  /** how many came last */
  #before = 0;

  /**
   * @param own writes before it returns
   * @param now ms by a clock that is never set back
   */
  constructor(own: Journal, thread: Journal, now: () => number = () => performance.now()) {
    this.#own = own;
    this.#thread = thread;
    this.#now = now;
  }

  write(entries: readonly Entry[], tidying: Tidying | null, told: Told): void {
    const begun = this.#now();
    const isLittle = tidying === null && Math.max(entries.length, this.#before) <= FEW;
    this.#before = entries.length;
    const isOwn = isLittle && begun >= this.#slowUntil;
    (isOwn ? this.#own : this.#thread).write(entries, tidying, (...how) => {
      if (isOwn) this.#took(this.#now() - begun);
      told(...how);
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
