/**
 * Periodic task that visits all members. It spreads its visits over turns of the event loop, so
 * that other work waits for a few visits only.
 */
import type { Clock } from "./clock.ts";

const MIN_PER_TURN = 10;
/** Upper bound for the number of turns of a pass, for any number of members. */
const MAX_TURNS = 50;
const TURN_DELAY_MS = 15;

export interface StaggeredIntervalParts<T> {
  clock: Clock;
  /**
   * ms from the start of a pass to the start of the next. If a pass takes long, the next one starts
   * a quarter of this after its end.
   */
  everyMs: number;
  /** members at the start of a pass; some may be removed before their visit */
  members: () => Iterable<T>;
  /** must not fail; the next pass starts after its promise resolves */
  visit: (member: T) => Promise<void> | void;
}

export class StaggeredInterval<T> {
  readonly #parts: StaggeredIntervalParts<T>;
  #cancelTimer: () => void;
  #isClosed = false;

  /** The first pass starts after `everyMs`. */
  constructor(parts: StaggeredIntervalParts<T>) {
    this.#parts = parts;
    this.#cancelTimer = parts.clock.after(parts.everyMs, () => void this.#run());
  }

  close(): void {
    this.#isClosed = true;
    this.#cancelTimer();
  }

  async #run(): Promise<void> {
    const { clock, everyMs, members, visit } = this.#parts;
    const startedAt = clock.now();
    const all = [...members()];
    const perTurn = Math.max(MIN_PER_TURN, Math.ceil(all.length / MAX_TURNS));
    const pending: Promise<void>[] = [];
    for (let visited = 0; visited < all.length;) {
      if (visited > 0) await this.#wait(TURN_DELAY_MS);
      // A busy relay wakes late from each delay and catches up.
      const turns = 1 + Math.floor((clock.now() - startedAt) / TURN_DELAY_MS);
      const due = all.slice(visited, turns * perTurn);
      visited += due.length;
      for (const member of due) {
        const done = visit(member);
        if (done instanceof Promise) pending.push(done);
      }
    }
    await Promise.all(pending);
    if (this.#isClosed) return;
    const leftMs = Math.max(everyMs / 4, startedAt + everyMs - clock.now());
    this.#cancelTimer = clock.after(leftMs, () => void this.#run());
  }

  /** Waits. Never resolves after `close`. */
  #wait(ms: number): Promise<void> {
    return new Promise((resolve) => {
      this.#cancelTimer = this.#parts.clock.after(ms, resolve);
    });
  }
}
