/**
 * From elapsed time to whole ticks. What does not fill a tick is kept for the next time; a gap longer
 * than the limit is a pause and is not caught up, so that a sleeping machine does not wake to minutes.
 */
import { TICKS_PER_SECOND } from "./settings.ts";

/** Longest gap that is caught up, in ms of real time. */
const MAX_GAP_MS = 250;

export class FixedTimestep {
  /** below 0 where the first tick came before its time */
  #rest = 0;
  #isFirst = false;

  /**
   * @param elapsedMs real time since the last call
   * @param speed simulated seconds in a real second
   * @returns whole ticks to run now
   */
  ticksFor(elapsedMs: number, speed: number): number {
    this.#rest += (Math.min(elapsedMs, MAX_GAP_MS) * speed * TICKS_PER_SECOND) / 1000;
    const ticks = Math.max(this.#isFirst ? 1 : 0, Math.floor(this.#rest));
    this.#isFirst = false;
    this.#rest -= ticks;
    return ticks;
  }

  /** Time begins anew. The first tick comes at once: who starts the robot waits for nothing. */
  start(): void {
    this.#rest = 0;
    this.#isFirst = true;
  }

  /** Forgets the part of a tick that is left, when time begins anew. */
  clear(): void {
    this.#rest = 0;
  }
}
