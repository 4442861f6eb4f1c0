/**
 * The page's copy of the run's timeline. News may come with every frame; whoever shows them is told at
 * most ten times a second.
 */
import { Timeline, type TimelineNews } from "@corridor/recording";

const INTERVAL_MS = 100;

export class TimelineStore {
  /** changes with the news: read it in a listener, not while rendering */
  readonly timeline = new Timeline();
  readonly #later: (run: () => void, milliseconds: number) => void;
  readonly #listeners = new Set<() => void>();
  #isResting = false;
  #hasNews = false;

  /** @param later runs a function later, such as `setTimeout` */
  constructor(later: (run: () => void, milliseconds: number) => void) {
    this.#later = later;
  }

  /** Takes in what the worker recorded. */
  take(news: TimelineNews): void {
    this.timeline.merge(news);
    this.#hasNews = true;
    this.#tell();
  }

  /** Hears of news. @returns a function that ends it */
  listen(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #tell(): void {
    if (this.#isResting || !this.#hasNews) return;
    this.#hasNews = false;
    this.#isResting = true;
    this.#later(() => {
      this.#isResting = false;
      this.#tell();
    }, INTERVAL_MS);
    for (const listener of this.#listeners) listener();
  }
}
