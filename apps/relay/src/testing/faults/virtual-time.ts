/** Time for a whole world: relay, page and scripts live in the same moment, which moves when it is told to. */
import { setImmediate as turn } from "node:timers/promises";

/** Turns of the event loop without work, after which none is to come: promises hand on within one. */
const IDLE_TURNS = 2;

interface Timer {
  at: number;
  /** of two timers for the same moment the older one is first */
  order: number;
  call: () => void;
}

export class VirtualTime {
  #now = Date.UTC(2026, 0, 1);
  #order = 0;
  #timers: Timer[] = [];
  #isTouched = false;
  #atWork = 0;

  now(): number {
    return this.#now;
  }

  /** Calls once after so many ms. @returns a function that calls it off */
  after(ms: number, call: () => void): () => void {
    const timer = { at: this.#now + Math.ceil(ms), order: this.#order++, call };
    const place = this.#timers.findLastIndex(({ at }) => at <= timer.at);
    this.#timers.splice(place + 1, 0, timer);
    return () => {
      this.#timers = this.#timers.filter((other) => other !== timer);
    };
  }

  /** Something was begun that goes on in promises: the next moment waits for them. */
  touch(): void {
    this.#isTouched = true;
  }

  /** The next moment waits for this, too. */
  async during<T>(work: () => Promise<T>): Promise<T> {
    this.#isTouched = true;
    this.#atWork += 1;
    try {
      return await work();
    } finally {
      this.#atWork -= 1;
    }
  }

  async pass(ms: number): Promise<void> {
    const end = this.#now + ms;
    await this.#settle();
    for (;;) {
      const [due] = this.#timers;
      if (due === undefined || due.at > end) break;
      this.#timers.shift();
      this.#now = Math.max(this.#now, due.at);
      due.call();
      await this.#settle();
    }
    this.#now = end;
  }

  async #settle(): Promise<void> {
    if (!this.#isTouched) return;
    for (let idle = 0; idle < IDLE_TURNS; idle++) {
      if (this.#isTouched || this.#atWork > 0) idle = 0;
      this.#isTouched = false;
      await turn();
    }
  }
}
