/**
 * The page's copy of the run's timeline. News come with the frames of the panels, whose calm rate the
 * worker keeps.
 */
import { Timeline, type TimelineNews } from "@corridor/recording";

export class TimelineStore {
  /** changes with the news: read it in a listener, not while rendering */
  readonly timeline = new Timeline();
  readonly #listeners = new Set<() => void>();

  /** Takes in what the worker recorded. */
  take(news: TimelineNews): void {
    this.timeline.merge(news);
    for (const listener of this.#listeners) listener();
  }

  /** Hears of news. @returns a function that ends it */
  listen(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }
}
