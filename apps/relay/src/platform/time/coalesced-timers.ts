/**
 * Coalesced timers: calls that are due within the same 5 ms share one timer and one turn of the
 * event loop. On a busy relay thousands of readers a second wait for their next snapshot. A timer
 * and a turn for each would cost more than the work itself.
 */
import type { Clock } from "./clock.ts";

/** Granularity in ms. No call is early, and none is late by more than this. */
const SHARED_MS = 5;

/**
 * Next due time of a task that repeats at most every `everyMs`. Lateness of the timer is
 * compensated, so that 20 calls a second do not become 19. An early call does not shorten the next
 * interval.
 * @param due due time of the current call
 */
export function dueAfter(due: number, now: number, everyMs: number): number {
  return Math.min(now, Math.max(due, now - SHARED_MS)) + everyMs;
}

export interface Waiter {
  wake(): void;
}

export class CoalescedTimers {
  readonly #clock: Clock;
  /** waiters by the end of their 5 ms slot */
  readonly #sleepers = new Map<number, Waiter[]>();

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** Calls `wake` once, `ms` milliseconds from now or up to 5 ms later. It cannot be cancelled. */
  wakeAfter(ms: number, sleeper: Waiter): void {
    const now = this.#clock.now();
    const at = Math.ceil((now + ms) / SHARED_MS) * SHARED_MS;
    const others = this.#sleepers.get(at);
    if (others !== undefined) return void others.push(sleeper);
    const sleepers = [sleeper];
    this.#sleepers.set(at, sleepers);
    this.#clock.after(at - now, () => {
      this.#sleepers.delete(at);
      for (const each of sleepers) each.wake();
    });
  }
}
