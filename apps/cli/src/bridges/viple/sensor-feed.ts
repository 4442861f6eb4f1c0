/** Sends the newest readings on change, and again while nothing changes. */
import type { Timers } from "@corridor/protocol";

/** At most 20 messages a second. */
const MIN_INTERVAL_MS = 50;
const MAX_INTERVAL_MS = 250;

export class SensorFeed {
  readonly #timers: Timers;
  readonly #send: (text: string) => void;
  #newest = "";
  #sent = "";
  #sentAt = Number.NEGATIVE_INFINITY;
  #cancelTimer = (): void => undefined;

  constructor(timers: Timers, send: (text: string) => void) {
    this.#timers = timers;
    this.#send = send;
  }

  /** @param text the message with the newest readings */
  update(text: string): void {
    if (text === this.#newest) return;
    this.#newest = text;
    this.#schedule();
  }

  close(): void {
    this.#cancelTimer();
  }

  #schedule(): void {
    this.#cancelTimer();
    const interval = this.#newest === this.#sent ? MAX_INTERVAL_MS : MIN_INTERVAL_MS;
    const ms = Math.max(0, this.#sentAt + interval - this.#timers.now());
    this.#cancelTimer = this.#timers.after(ms, () => {
      this.#sent = this.#newest;
      this.#sentAt = this.#timers.now();
      this.#schedule();
      this.#send(this.#sent);
    });
  }
}
