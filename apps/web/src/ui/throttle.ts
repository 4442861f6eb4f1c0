/**
 * Throttles a changing value for screen readers: at most once a second, which people can follow; at
 * once if it stands still, or if something else than its number has changed.
 */
const INTERVAL_MS = 1000;

export class Throttle<Key> {
  readonly #now: () => number;
  #passedAt = Number.NEGATIVE_INFINITY;
  #key: Key | undefined;

  /** @param now monotonic milliseconds */
  constructor(now: () => number) {
    this.#now = now;
  }

  /**
   * @param isMoving whether another value follows soon, so that this one may be skipped
   * @param key part of the value that must not be delayed, compared by identity
   * @returns whether to report the value now
   */
  isDue(isMoving: boolean, key: Key): boolean {
    const now = this.#now();
    const isUrgent = !isMoving || key !== this.#key;
    this.#key = key;
    if (!isUrgent && now - this.#passedAt < INTERVAL_MS) return false;
    this.#passedAt = now;
    return true;
  }
}
