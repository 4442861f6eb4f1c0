/**
 * The page's copy of the run's timeline. News come with the frames of the panels, whose calm rate the
 * worker keeps. What reads them comes later than the first of them: they wait for it.
 */
import type { Timeline, TimelineDelta } from "@corridor/recording";

export class TimelineStore {
  #timeline: Timeline | null = null;
  /** news from before it was opened */
  #waiting: TimelineDelta[] = [];
  readonly #listeners = new Set<() => void>();

  /** The timeline, which changes with the news: read it in a listener, not while rendering. */
  open(create: () => Timeline): Timeline {
    if (this.#timeline !== null) return this.#timeline;
    const timeline = create();
    this.#timeline = timeline;
    for (const news of this.#waiting) timeline.applyDelta(news);
    this.#waiting = [];
    this.#tell();
    return timeline;
  }

  /** Ticks up to the end of `tick` in which a script let the robot wait. */
  waitedUpTo(tick: number): number {
    return this.#timeline?.commands.waitedUpTo(tick) ?? 0;
  }

  /** Takes in what the worker recorded. */
  take(news: TimelineDelta): void {
    if (this.#timeline === null) {
      this.#waiting.push(news);
      return;
    }
    this.#timeline.applyDelta(news);
    this.#tell();
  }

  /** Hears of news. @returns a function that ends it */
  listen(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #tell(): void {
    for (const listener of this.#listeners) listener();
  }
}
