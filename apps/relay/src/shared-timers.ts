/**
 * Timers that many share: whoever is to be woken within the same 5 ms is woken in one turn. At a busy relay
 * thousands of readers a second wait for their next snapshot, and a timer for each, with a turn of the event loop
 * of its own, costs more than what is done in it.
 */
import type { Clock } from "./clock.ts";

/** Nobody is woken early, and nobody later than by this. */
const SHARED_MS = 5;

/**
 * When the next one of those that go at most so often is due. What a timer came late does not count, so that 20 a
 * second do not become 19; nor does it count against the next that one went early.
 * @param due when this one was
 */
export function dueAfter(due: number, now: number, everyMs: number): number {
  return Math.min(now, Math.max(due, now - SHARED_MS)) + everyMs;
}

export interface Sleeper {
  wake(): void;
}

export class SharedTimers {
  readonly #clock: Clock;
  /** by the end of their 5 ms */
  readonly #sleepers = new Map<number, Sleeper[]>();

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** Wakes once, after so many ms or up to 5 ms later. Cannot be called off: who needs it no more sleeps on. */
  wakeAfter(ms: number, sleeper: Sleeper): void {
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
