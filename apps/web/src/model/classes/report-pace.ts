import { REPORT_RATE } from "@corridor/protocol";

/** How often a page may send reports: a little less than the relay accepts. */
const INTERVAL_MS = 1_050 / REPORT_RATE.perSecond;
/** A reload starts again, and must not exceed the limit together with the page before it. */
const BURST = REPORT_RATE.burst / 2;

export class ReportPace {
  #allowed = BURST;
  #countedAt: number;

  /** @param now monotonic milliseconds */
  constructor(now: number) {
    this.#countedAt = now;
  }

  /** Takes one report. @returns 0, or the milliseconds to wait before the next call */
  take(now: number): number {
    const gained = (now - this.#countedAt) / INTERVAL_MS;
    this.#allowed = Math.min(BURST, this.#allowed + gained);
    this.#countedAt = now;
    if (this.#allowed < 1) return Math.ceil((1 - this.#allowed) * INTERVAL_MS);
    this.#allowed -= 1;
    return 0;
  }
}
