/** Waits for changes in the store, which this relay or another one may write. */
import type { Clock } from "../platform/time/clock.ts";
import { Refusal, retryAfter } from "../platform/errors/problems.ts";
import type { WaitLimit } from "../platform/time/wait-limit.ts";
import { limits } from "../platform/limits/limits.ts";

export class Waits {
  readonly #clock: Clock;
  readonly #waiters = new Map<() => void, string>();
  #isClosed = false;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /**
   * Polls until a result is final or the timeout ends.
   * @param topic name of the awaited change; the number of waits for one topic is limited
   * @returns the last result
   */
  async until<T>(
    topic: string,
    poll: () => Promise<T>,
    isDone: (found: T) => boolean,
    { milliseconds, signal }: WaitLimit,
  ): Promise<T> {
    const end = this.#clock.now() + milliseconds;
    for (;;) {
      const found = await poll();
      const leftMs = end - this.#clock.now();
      if (isDone(found) || leftMs <= 0 || signal.aborted || this.#isClosed) return found;
      await this.#wait(topic, Math.min(leftMs, limits.pairingPollMs), signal);
    }
  }

  /** Polls again immediately in all waits, after a change by this relay. */
  wake(): void {
    for (const wake of this.#waiters.keys()) wake();
  }

  /** Ends all current and future waits. */
  close(): void {
    this.#isClosed = true;
    this.wake();
  }

  async #wait(topic: string, ms: number, signal: AbortSignal): Promise<void> {
    const same = [...this.#waiters.values()].filter((other) => other === topic).length;
    if (same >= limits.waitsPerPairing || this.#waiters.size >= limits.pairingWaits) {
      throw new Refusal(
        "too-many-readers",
        "Too many requests wait for a pairing. Send this request again in 2 s.",
        {
          headers: retryAfter(2_000),
        },
      );
    }
    await new Promise<void>((resolve) => {
      const wake = (): void => {
        this.#waiters.delete(wake);
        cancelTimer();
        signal.removeEventListener("abort", wake);
        resolve();
      };
      const cancelTimer = this.#clock.after(ms, wake);
      signal.addEventListener("abort", wake);
      this.#waiters.set(wake, topic);
    });
  }
}
