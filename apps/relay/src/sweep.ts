/**
 * Visits everybody again and again, a few in a turn: where hundreds are there, whoever comes between waits for a few
 * of them and not for all.
 */
import type { Clock } from "./clock.ts";

const FEW = 10;
/** However many there are, a sweep is over after so many turns. */
const MOST_TURNS = 50;
const PAUSE_MS = 15;

export interface SweepParts<T> {
  clock: Clock;
  /** from the beginning of one to that of the next; longer, with a pause of a quarter of it, where what is done in one takes long */
  everyMs: number;
  /** who is there as a sweep begins; some may be gone when their turn comes */
  members: () => Iterable<T>;
  /** must not fail; the next sweep waits for what it does */
  visit: (member: T) => Promise<void> | void;
}

export class Sweep<T> {
  readonly #parts: SweepParts<T>;
  #cancelTimer: () => void;
  #isClosed = false;

  /** The first begins after `everyMs`. */
  constructor(parts: SweepParts<T>) {
    this.#parts = parts;
    this.#cancelTimer = parts.clock.after(parts.everyMs, () => void this.#run());
  }

  close(): void {
    this.#isClosed = true;
    this.#cancelTimer();
  }

  async #run(): Promise<void> {
    const { clock, everyMs, members, visit } = this.#parts;
    const begun = clock.now();
    const all = [...members()];
    const inTurn = Math.max(FEW, Math.ceil(all.length / MOST_TURNS));
    const work: Promise<void>[] = [];
    for (let visited = 0; visited < all.length;) {
      if (visited > 0) await this.#passed(PAUSE_MS);
      // A relay that is busy wakes late from each pause, and makes up for it.
      const turns = 1 + Math.floor((clock.now() - begun) / PAUSE_MS);
      const due = all.slice(visited, turns * inTurn);
      visited += due.length;
      for (const member of due) {
        const done = visit(member);
        if (done instanceof Promise) work.push(done);
      }
    }
    await Promise.all(work);
    if (this.#isClosed) return;
    const leftMs = Math.max(everyMs / 4, begun + everyMs - clock.now());
    this.#cancelTimer = clock.after(leftMs, () => void this.#run());
  }

  /** Once it is closed that is never. */
  #passed(ms: number): Promise<void> {
    return new Promise((resolve) => {
      this.#cancelTimer = this.#parts.clock.after(ms, resolve);
    });
  }
}
