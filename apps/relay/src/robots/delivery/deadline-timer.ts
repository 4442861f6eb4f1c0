/** Timer for the earliest of many deadlines. */
import type { Clock } from "../../platform/time/clock.ts";

export class DeadlineTimer {
  readonly #clock: Clock;
  readonly #due: () => void;
  #at = Number.POSITIVE_INFINITY;
  #cancel: () => void = () => undefined;

  /** @param due called at the deadline; callers with a later deadline call `wake` again */
  constructor(clock: Clock, due: () => void) {
    this.#clock = clock;
    this.#due = due;
  }

  /** Sets the timer to this time, unless it is set to an earlier one. */
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
