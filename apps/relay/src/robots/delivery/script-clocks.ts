/**
 * Transit times of the messages of scripts. Scripts that send single requests and share a key may
 * run on different computers, so each one names its clock with an id. A connection belongs to one
 * script, and so to one clock.
 */
import { MAX_CLOCK_DRIFT } from "@corridor/protocol";
import { limits } from "../../platform/limits/limits.ts";

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
  measure(driver: string, time: ScriptTime | null, arrivedAt: number): number {
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
    return estimate.measure(time.sentAt, arrivedAt);
  }

  /** Deletes the clocks of a revoked key. */
  revoked(driver: string): void {
    this.#clocks.delete(driver);
  }
}

/**
 * Estimates the transit time of one sender's messages. It never compares the clocks of sender and
 * relay. It only measures how much later than the fastest message another one arrived.
 */
export class TransitEstimate {
  /**
   * smallest difference between the relay's and the sender's clock; Infinity before the first
   * message
   */
  #offset = Infinity;

  /**
   * Records a message.
   * @param sentAt ms of the sender's monotonic clock; only differences count
   * @param arrivedAt ms of the relay's clock
   * @returns ms of transit beyond the fastest message so far; 0 for the first, never negative
   */
  measure(sentAt: number, arrivedAt: number): number {
    // Counts the relay's time slightly slow, so that drift only lowers the offset.
    const offset = arrivedAt * (1 - MAX_CLOCK_DRIFT) - sentAt;
    this.#offset = Math.min(this.#offset, offset);
    return Math.round(offset - this.#offset);
  }
}
