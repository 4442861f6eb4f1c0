/**
 * When a reader says `seen`. It is cumulative, and the relay lets two snapshots be on their way: so every
 * second one is enough, and saves the relay a third of all that comes in.
 *
 * Not over a long line: there the relay would wait for the word about the second one, and fewer snapshots would come.
 * The reader notices that by a snapshot that comes late, and says each for a while. A page that reports
 * seldom looks the same, and its few are said one by one.
 */

/** Snapshots of a page that reports come each 33 to 67 ms; one that the relay held up comes when it was said that the
 * one before it was seen: up to 80 ms nobody can tell the two apart, and such a line loses a tenth of its snapshots. */
const LATE_MS = 80;
/** After a late one. A try to say every second costs one more late snapshot. */
const CAREFUL_MS = 5_000;

export class SeenPace {
  #isUnsaid = false;
  /** when the last one came; null at the beginning of a line */
  #cameAt: number | null = null;
  #carefulUntil = -Infinity;

  /** A new line: what was on its way on an old one does not count there. */
  begin(): void {
    this.#isUnsaid = false;
    this.#cameAt = null;
  }

  /**
   * A snapshot was read, also the one in the welcome.
   * @param now ms
   * @returns whether to say so; of two in a row one is said
   */
  read(now: number): boolean {
    const isFirst = this.#cameAt === null;
    if (this.#cameAt !== null && now - this.#cameAt > LATE_MS)
      this.#carefulUntil = now + CAREFUL_MS;
    this.#cameAt = now;
    const isDue = isFirst || this.#isUnsaid || now < this.#carefulUntil;
    this.#isUnsaid = !isDue;
    return isDue;
  }
}
