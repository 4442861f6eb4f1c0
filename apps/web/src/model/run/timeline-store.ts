/**
 * The page's copy of the run's timeline. Deltas arrive with the throttled frames of the panels. Its
 * readers load after the first delta; until then deltas are queued.
 */
import type { Timeline, TimelineDelta } from "@corridor/recording";

export class TimelineStore {
  #timeline: Timeline | null = null;
  /** deltas from before it was opened */
  #pending: TimelineDelta[] = [];
  readonly #listeners = new Set<() => void>();

  /** The timeline, which deltas change in place: read it in a listener, not while rendering. */
  open(create: () => Timeline): Timeline {
    if (this.#timeline !== null) return this.#timeline;
    const timeline = create();
    this.#timeline = timeline;
    for (const delta of this.#pending) timeline.applyDelta(delta);
    this.#pending = [];
    this.#notify();
    return timeline;
  }

  /** Ticks up to the end of `tick` in which a script made the robot wait. */
  waitedUpTo(tick: number): number {
    return this.#timeline?.commands.waitedUpTo(tick) ?? 0;
  }

  /** Applies a delta from the worker. */
  add(delta: TimelineDelta): void {
    if (this.#timeline === null) {
      this.#pending.push(delta);
      return;
    }
    this.#timeline.applyDelta(delta);
    this.#notify();
  }

  /**
   * Subscribes to changes.
   * @returns a function that unsubscribes
   */
  listen(listener: () => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #notify(): void {
    for (const listener of this.#listeners) listener();
  }
}
