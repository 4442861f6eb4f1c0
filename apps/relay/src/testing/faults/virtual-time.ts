/** Virtual time shared by relay, page and scripts. It advances only on request. */
import { setImmediate as turn } from "node:timers/promises";

/** Idle turns of the event loop after which no promise is pending. Promises continue within one. */
const IDLE_TURNS = 2;

interface Timer {
  at: number;
  /** tie-breaker of timers with equal time: older first */
  order: number;
  call: () => void;
}

export class VirtualTime {
  #now = Date.UTC(2026, 0, 1);
  #order = 0;
  #timers: Timer[] = [];
  #isTouched = false;
  #pending = 0;

  now(): number {
    return this.#now;
  }

  /** Calls `call` once after `ms` milliseconds. @returns a function that cancels the call */
  after(ms: number, call: () => void): () => void {
    const timer = { at: this.#now + Math.ceil(ms), order: this.#order++, call };
    const place = this.#timers.findLastIndex(({ at }) => at <= timer.at);
    this.#timers.splice(place + 1, 0, timer);
    return () => {
      this.#timers = this.#timers.filter((other) => other !== timer);
    };
  }

  /** Marks the start of asynchronous work. Time advances after it. */
  touch(): void {
    this.#isTouched = true;
  }

  /** Runs asynchronous work. Time advances after it. */
  async during<T>(work: () => Promise<T>): Promise<T> {
    this.#isTouched = true;
    this.#pending += 1;
    try {
      return await work();
    } finally {
      this.#pending -= 1;
    }
  }

  async pass(ms: number): Promise<void> {
    const end = this.#now + ms;
    await this.#waitForIdle();
    for (;;) {
      const [due] = this.#timers;
      if (due === undefined || due.at > end) break;
      this.#timers.shift();
      this.#now = Math.max(this.#now, due.at);
      due.call();
      await this.#waitForIdle();
    }
    this.#now = end;
  }

  async #waitForIdle(): Promise<void> {
    if (!this.#isTouched) return;
    for (let idle = 0; idle < IDLE_TURNS; idle++) {
      if (this.#isTouched || this.#pending > 0) idle = 0;
      this.#isTouched = false;
      await turn();
    }
  }
}
