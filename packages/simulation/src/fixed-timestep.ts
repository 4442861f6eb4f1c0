/**
 * Converts elapsed time to whole ticks and carries the remainder over to the next call. Time beyond
 * the maximum gap is discarded, so that a machine that wakes from sleep does not run minutes of
 * ticks.
 */
import { TICKS_PER_SECOND } from "@corridor/protocol";

/** Maximum elapsed time per call, in ms of real time. */
const MAX_GAP_MS = 250;

export class FixedTimestep {
  /** fraction of a tick; negative after the first tick, which runs early */
  #remainder = 0;
  #isFirst = false;

  /**
   * @param elapsedMs real time since the last call
   * @param speed simulated seconds per real second
   * @returns number of ticks to run now
   */
  ticksFor(elapsedMs: number, speed: number): number {
    this.#remainder += (Math.min(elapsedMs, MAX_GAP_MS) * speed * TICKS_PER_SECOND) / 1000;
    const ticks = Math.max(this.#isFirst ? 1 : 0, Math.floor(this.#remainder));
    this.#isFirst = false;
    this.#remainder -= ticks;
    return ticks;
  }

  /**
   * Resets the time. The next call returns at least one tick, so that the robot reacts immediately.
   */
  start(): void {
    this.#remainder = 0;
    this.#isFirst = true;
  }

  /** Discards the remaining fraction of a tick. */
  clear(): void {
    this.#remainder = 0;
  }
}
