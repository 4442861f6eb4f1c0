/**
 * How long a message of the relay was on its way: held up in the net, or unread because the page was
 * frozen. The clocks of relay and page are never compared, only how each goes on since the relay
 * answered the page.
 *
 * An answer shows two bounds: the relay gave it after the page had asked, and before it came. What lies
 * between them counts as the way back, for nobody knows how much of it was: so a command may be thought
 * older than it is, never much younger. The page asks again until an answer was quick.
 */

/** Where an answer takes no longer, its halves are as good as equal: what a command may be late by. */
const LARGEST_DOUBT_MS = 50;

export class TransitClock {
  /** when the page asked what is not answered yet; null: nothing */
  #askedAt: number | null = null;
  /** the page's clock minus the relay's, as far as is known; null before the first answer */
  #offset: number | null = null;
  /** ms that the quickest answer took */
  #quickest = Infinity;

  /** The page has sent its greeting: another relay may answer, by another clock. */
  greeted(now: number): void {
    this.#askedAt = now;
    this.#offset = null;
    this.#quickest = Infinity;
  }

  /** Whether to ask the relay for its time, for no answer was quick and none is to come. */
  get isVague(): boolean {
    return this.#askedAt === null && this.#quickest > 2 * LARGEST_DOUBT_MS;
  }

  /** The page has asked again. */
  asked(now: number): void {
    this.#askedAt = now;
  }

  /** The answer to the greeting, or to what was asked since. */
  answered(at: number, now: number): void {
    if (this.#askedAt === null) return;
    const took = now - this.#askedAt;
    this.#askedAt = null;
    if (took >= this.#quickest) return;
    this.#quickest = took;
    const wayThere = Math.min(LARGEST_DOUBT_MS, took / 2);
    this.#offset = now - took + wayThere - at;
  }

  /**
   * A message came.
   * @param at when the relay sent it, by the relay's clock
   * @returns ms that it was on its way
   */
  came(at: number, now: number): number {
    // Before the answer to its greeting the page knows only that it did not listen before.
    if (this.#offset === null) return now - (this.#askedAt ?? now);
    // A message that came faster than was thought possible shows that the answer took longer back.
    this.#offset = Math.min(this.#offset, now - at);
    return now - at - this.#offset;
  }
}
