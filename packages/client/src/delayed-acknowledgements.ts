/**
 * When a reader says `seen`. It is cumulative, and the relay lets two snapshots be on their way: so every
 * second one is enough, and saves the relay a third of all that comes in.
 *
 * Not over a long line: there the relay waits for the word about the second one, and fewer snapshots come. No message
 * tells how long a line is, but the pauses do: one that the relay waited in comes after a snapshot that was said, and is
 * as long as the line there and back; the other one of each two is as long as the page's own. So the reader sums up by
 * how much the first are longer than the second. Where that grows it says each for a while, and then tries again, later
 * each time. A page that reports seldom is said one by one, too: its few cost nothing.
 */

/** Pauses of a page that reports are 33 to 67 ms: a longer one was waited in, or belongs to a page that reports seldom. */
const LATE_MS = 80;
/** So much may one pause of two be longer: the relay makes up for it, and timers are no better. */
const UNEVEN_MS = 4;
/** One pair counts no more than this: a reader that was busy for a moment gets two at once. */
const LARGEST_MS = 25;
/** What lateness in a row shows a long line: less than a snapshot's time. */
const LONG_MS = 30;
/** After what was late, and how long at most where tries fail. A try costs one late snapshot or two. */
const CAREFUL_MS = { first: 5_000, most: 60_000 };
/** After so long without a late one a line counts as short again. */
const TRUSTED_MS = 10_000;

export class SeenPace {
  /** whether the last one was said; null: none has come on this line */
  #wasSaid: boolean | null = null;
  #cameAt = 0;
  #carefulUntil = -Infinity;
  #carefulMs = CAREFUL_MS.first;
  /** the pause after the last one that was said */
  #saidPause: number | null = null;
  /** by how much the pauses after those that were said have been longer than the others, lately */
  #lateness = 0;

  /** A new line: what was on its way on an old one does not count there, nor how long that was. */
  begin(): void {
    this.#wasSaid = null;
    this.#carefulUntil = -Infinity;
    this.#carefulMs = CAREFUL_MS.first;
    this.#measureAnew();
  }

  /**
   * A snapshot was read, also the one in the welcome.
   * @param now ms
   * @returns whether to say so; of two in a row one is said
   */
  read(now: number): boolean {
    if (this.#wasSaid !== null) this.#measure(now - this.#cameAt, this.#wasSaid, now);
    this.#cameAt = now;
    this.#wasSaid = this.#wasSaid !== true || now < this.#carefulUntil;
    return this.#wasSaid;
  }

  #measure(pause: number, wasSaid: boolean, now: number): void {
    const isCareful = now < this.#carefulUntil;
    if (isCareful) {
      // A try would be late as well.
      if (pause > LATE_MS) this.#carefulUntil = now + this.#carefulMs;
      return;
    }
    if (pause > LATE_MS) return this.#wasLate(now);
    if (now - this.#carefulUntil > TRUSTED_MS) this.#carefulMs = CAREFUL_MS.first;
    if (wasSaid) {
      this.#saidPause = pause;
    } else if (this.#saidPause !== null) {
      const longer = Math.min(this.#saidPause - pause - UNEVEN_MS, LARGEST_MS);
      this.#lateness = Math.max(0, this.#lateness + longer);
      this.#saidPause = null;
      if (this.#lateness > LONG_MS) this.#wasLate(now);
    }
  }

  #wasLate(now: number): void {
    this.#carefulUntil = now + this.#carefulMs;
    this.#carefulMs = Math.min(2 * this.#carefulMs, CAREFUL_MS.most);
    this.#measureAnew();
  }

  #measureAnew(): void {
    this.#saidPause = null;
    this.#lateness = 0;
  }
}
