/** Requests that wait for something in the store, which this relay or another one may bring about. */
import type { Clock } from "../clock.ts";
import { Refusal, retryAfter } from "../problems.ts";
import type { Patience } from "../sessions/audience.ts";
import { limits } from "../sessions/limits.ts";

export class Waits {
  readonly #clock: Clock;
  readonly #wakers = new Map<() => void, string>();
  #isClosed = false;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /**
   * Looks until what it finds is what was waited for, or the patience is over.
   * @param what names that which is waited for; not too many may wait for the same
   * @returns what was found last
   */
  async until<T>(
    what: string,
    look: () => Promise<T>,
    isDone: (found: T) => boolean,
    { milliseconds, signal }: Patience,
  ): Promise<T> {
    const end = this.#clock.now() + milliseconds;
    for (;;) {
      const found = await look();
      const leftMs = end - this.#clock.now();
      if (isDone(found) || leftMs <= 0 || signal.aborted || this.#isClosed) return found;
      await this.#pause(what, Math.min(leftMs, limits.pairingLookMs), signal);
    }
  }

  /** Something has changed at this relay: all look again at once. */
  wake(): void {
    for (const wake of this.#wakers.keys()) wake();
  }

  /** Ends all waits, now and later. */
  close(): void {
    this.#isClosed = true;
    this.wake();
  }

  async #pause(what: string, ms: number, signal: AbortSignal): Promise<void> {
    const same = [...this.#wakers.values()].filter((other) => other === what).length;
    if (same >= limits.waitsPerPairing || this.#wakers.size >= limits.pairingWaits) {
      throw new Refusal("too-many-readers", "Too many wait for this already. Wait a moment.", {
        headers: retryAfter(2_000),
      });
    }
    await new Promise<void>((resolve) => {
      const wake = (): void => {
        this.#wakers.delete(wake);
        cancelTimer();
        signal.removeEventListener("abort", wake);
        resolve();
      };
      const cancelTimer = this.#clock.after(ms, wake);
      signal.addEventListener("abort", wake);
      this.#wakers.set(wake, what);
    });
  }
}
