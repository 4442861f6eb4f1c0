export const FIRST_DELAY_MS = 250;
const MAX_DELAY_MS = 10_000;

/**
 * Exponential backoff with full jitter, so that clients which lost the same network do not
 * reconnect at the same moment. The upper bound of the delays doubles from 0.25 s to 10 s. It never
 * exceeds twice the time since the first failure, so that a short outage never leads to a long
 * delay.
 */
export class Backoff {
  #failures = 0;
  /** time of the first failure since the last reset */
  #since = 0;

  /**
   * The delay after a failure.
   * @param now ms
   * @param random from 0 to below 1
   * @returns ms
   */
  next(now: number, random: number): number {
    if (this.#failures === 0) this.#since = now;
    const limit = Math.min(
      MAX_DELAY_MS,
      FIRST_DELAY_MS * 2 ** this.#failures,
      Math.max(FIRST_DELAY_MS, 2 * (now - this.#since)),
    );
    this.#failures += 1;
    return random * limit;
  }

  /** To be called after a success. */
  reset(): void {
    this.#failures = 0;
  }
}
