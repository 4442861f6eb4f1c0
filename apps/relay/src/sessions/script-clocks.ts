/**
 * The clocks of the scripts that send single requests. Several scripts may share a key and run on different
 * computers, so each names its clock by an id of its own.
 */
import { limits } from "./limits.ts";
import { TransitEstimate } from "./transit-estimate.ts";

/** A moment by a script's own monotonic clock, as the header `Script-Clock` gives it. */
export interface ScriptTime {
  /** of the clock: random text, the same for all requests that are timed by it */
  clock: string;
  /** ms by that clock */
  sentAt: number;
}

export class ScriptClocks {
  /** by the hash of the key, and then by the id of the clock; the one that was heard last is the last */
  readonly #clocks = new Map<string, Map<string, TransitEstimate>>();

  /**
   * A request came.
   * @param driver hash of its key
   * @returns ms that it was on its way longer than the quickest one by the same clock; 0 where it tells no time
   */
  came(driver: string, time: ScriptTime | null, cameAt: number): number {
    if (time === null) return 0;
    const ofKey = this.#clocks.get(driver) ?? new Map<string, TransitEstimate>();
    this.#clocks.set(driver, ofKey);
    const estimate = ofKey.get(time.clock) ?? new TransitEstimate();
    ofKey.delete(time.clock);
    ofKey.set(time.clock, estimate);
    for (const oldest of ofKey.keys()) {
      if (ofKey.size <= limits.clocksPerKey) break;
      ofKey.delete(oldest);
    }
    return estimate.came(time.sentAt, cameAt);
  }

  /** A key counts no more. */
  revoked(driver: string): void {
    this.#clocks.delete(driver);
  }
}
