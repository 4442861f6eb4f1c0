/** Wakes when the first of many deadlines is there. */
import type { Clock } from "../clock.ts";

export class DeadlineTimer {
  readonly #clock: Clock;
  readonly #due: () => void;
  #at = Number.POSITIVE_INFINITY;
  #cancel: () => void = () => undefined;

  /** @param due is called at the deadline; who still waits for a later one says so by `wake` */
  constructor(clock: Clock, due: () => void) {
    this.#clock = clock;
    this.#due = due;
  }

  /** Wakes at this time, or earlier where something else is due earlier. */
  wake(at: number): void {
    if (at >= this.#at) return;
    this.#at = at;
    this.#cancel();
    this.#cancel = this.#clock.after(Math.max(0, at - this.#clock.now()), () => {
      this.#at = Number.POSITIVE_INFINITY;
      this.#due();
    });
  }

  close(): void {
    this.#cancel();
    this.#at = Number.NEGATIVE_INFINITY;
  }
}
