/** Maximum error: of a round trip, at most this much counts as the way to the relay. */
const MAX_ERROR_MS = 50;

/**
 * Measures the transit time of the relay's messages: the delay in the network, and the time that
 * they waited in a frozen page. The clocks of page and relay need not agree; only differences
 * matter.
 *
 * The relay sends a response after the page has sent its request and before the page receives it.
 * The rest of the round trip counts as the way back, so a command may seem older than it is, but
 * never much younger. The page requests the time again until a round trip was short.
 */

export class TransitClock {
  /** send time of the unanswered request; null: none */
  #requestedAt: number | null = null;
  /** estimate of the page's clock minus the relay's; null before the first response */
  #offset: number | null = null;
  /** ms */
  #shortestRoundTrip = Infinity;

  /** The page has sent `hello`, perhaps to another relay with another clock. */
  helloSent(now: number): void {
    this.#requestedAt = now;
    this.#offset = null;
    this.#shortestRoundTrip = Infinity;
  }

  /** Whether to request the relay's time: no round trip was short, and none is pending. */
  get isImprecise(): boolean {
    return this.#requestedAt === null && this.#shortestRoundTrip > 2 * MAX_ERROR_MS;
  }

  /** The page has requested the time. */
  timeRequested(now: number): void {
    this.#requestedAt = now;
  }

  /** The response to `hello` or `time`. @param at send time by the relay's clock */
  answered(at: number, now: number): void {
    if (this.#requestedAt === null) return;
    const roundTrip = now - this.#requestedAt;
    this.#requestedAt = null;
    if (roundTrip >= this.#shortestRoundTrip) return;
    this.#shortestRoundTrip = roundTrip;
    const toRelay = Math.min(MAX_ERROR_MS, roundTrip / 2);
    this.#offset = now - roundTrip + toRelay - at;
  }

  /**
   * A message was received.
   * @param at send time by the relay's clock
   * @returns its transit time in ms
   */
  transitMs(at: number, now: number): number {
    // Before the first response, the message can be as old as the connection.
    if (this.#offset === null) return now - (this.#requestedAt ?? now);
    // A message with a negative transit time proves that the way back of the response took longer.
    this.#offset = Math.min(this.#offset, now - at);
    return now - at - this.#offset;
  }
}
