/**
 * Clocks of scripts that send single requests. Scripts that share a key may run on different
 * computers, so each one names its clock with an id.
 */
import { limits } from "../../platform/limits/limits.ts";
import { TransitEstimate } from "./transit-estimate.ts";

/** A time of a script's own monotonic clock, from the header `Script-Clock`. */
export interface ScriptTime {
  /** id of the clock: random text, the same for all requests with that clock */
  clock: string;
  /** ms by that clock */
  sentAt: number;
}

export class ScriptClocks {
  /** by the hash of the key, then by the id of the clock, least recently used first */
  readonly #clocks = new Map<string, Map<string, TransitEstimate>>();

  /**
   * Records a request.
   * @param driver hash of its key
   * @returns ms of transit beyond the fastest request with the same clock; 0 without a time
   */
  came(driver: string, time: ScriptTime | null, arrivedAt: number): number {
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
    return estimate.came(time.sentAt, arrivedAt);
  }

  /** Deletes the clocks of a revoked key. */
  revoked(driver: string): void {
    this.#clocks.delete(driver);
  }
}
