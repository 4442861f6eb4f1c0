/**
 * How long a message of the relay was on its way: held up in the net, or unread because the page was
 * frozen. The clocks of relay and page are never compared, only how each goes on since the greeting.
 */

/** A greeting may be answered late for other reasons than the way there and back. */
const LONGEST_HALF_MS = 250;

export class TransitClock {
  #greetedAt = 0;
  /** the page's clock minus the relay's, as far as is known; null before the welcome */
  #offset: number | null = null;

  /** The page has sent its greeting. */
  greeted(now: number): void {
    this.#greetedAt = now;
    this.#offset = null;
  }

  /**
   * A message came.
   * @param at when the relay sent it, by the relay's clock
   * @returns ms that it was on its way
   */
  came(at: number, now: number): number {
    const ways = now - this.#greetedAt;
    this.#offset ??= now - at - Math.min(LONGEST_HALF_MS, ways / 2);
    // A message that came faster than was thought possible shows that less time had passed.
    this.#offset = Math.min(this.#offset, now - at);
    return now - at - this.#offset;
  }
}
