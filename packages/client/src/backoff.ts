/**
 * The pauses before what failed is tried again: each is drawn from 0 to a limit that doubles from 0.25 s to
 * 10 s (full jitter), so that a whole class does not come back in the same moment. It is never more than
 * twice the time since the first failure: after a short cut a few short pauses lead to no long one.
 */
export const FIRST_PAUSE_MS = 250;
const LONGEST_PAUSE_MS = 10_000;

export class RetryPauses {
  #failures = 0;
  /** when the first of these failed */
  #since = 0;

  /**
   * Something has failed.
   * @param now ms
   * @param chance from 0 to below 1
   * @returns ms
   */
  next(now: number, chance: number): number {
    if (this.#failures === 0) this.#since = now;
    const limit = Math.min(
      LONGEST_PAUSE_MS,
      FIRST_PAUSE_MS * 2 ** this.#failures,
      Math.max(FIRST_PAUSE_MS, 2 * (now - this.#since)),
    );
    this.#failures += 1;
    return chance * limit;
  }

  /** All is well again. */
  beginAnew(): void {
    this.#failures = 0;
  }
}
