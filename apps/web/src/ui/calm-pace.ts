/**
 * When a value that moves is told to those who listen: at most once a second, as a screen reader can
 * follow; at once where it stands still, or when something else than its numbers has changed.
 */
const CALM_MS = 1000;

export class CalmPace<News> {
  readonly #now: () => number;
  #toldAt = Number.NEGATIVE_INFINITY;
  #news: News | undefined;

  /** @param now monotonic milliseconds */
  constructor(now: () => number) {
    this.#now = now;
  }

  /**
   * @param isMoving whether another value follows soon, so that this one may be left out
   * @param news what must not wait, compared by identity
   * @returns whether the value is to be told now
   */
  isDue(isMoving: boolean, news: News): boolean {
    const now = this.#now();
    const isNews = !isMoving || news !== this.#news;
    this.#news = news;
    if (!isNews && now - this.#toldAt < CALM_MS) return false;
    this.#toldAt = now;
    return true;
  }
}
