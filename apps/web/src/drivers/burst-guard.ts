/**
 * Keeps velocities back that come all at once: whoever queues them while a line is broken sends them in
 * one burst, seconds old, when it is back. Of those only the last may move the robot.
 */

const BURST_MS = 50;
/** More velocities than this within `BURST_MS` are a burst. */
const BURST = 3;
/** After a new line, of the page or of a script. */
const NEW_LINE_MS = 100;

export class BurstGuard {
  #arrivals: number[] = [];
  #heldUntil = Number.NEGATIVE_INFINITY;
  /** the page's own line is new, and nothing has come over it yet */
  #isLineNew = false;

  /** Whether a velocity that waits must go on waiting. */
  isHeld(now: number): boolean {
    return now < this.#heldUntil;
  }

  /** A velocity came. */
  came(now: number): void {
    if (this.#isLineNew) this.#hold(now + NEW_LINE_MS);
    this.#isLineNew = false;
    this.#arrivals = [...this.#arrivals.filter((at) => now - at < BURST_MS), now];
    // Not again while it lasts: a flood must not keep the robot from its newest value for ever.
    if (this.#arrivals.length > BURST && !this.isHeld(now)) {
      this.#hold(now + BURST_MS);
      this.#arrivals = [];
    }
  }

  /** The page has a new line to the relay: what comes over it first was kept there. */
  newLine(): void {
    this.#isLineNew = true;
  }

  /** A script has had its line for so long: what comes over it first may have been kept by the script. */
  lineOf(ageMs: number, now: number): void {
    this.#hold(now + NEW_LINE_MS - ageMs);
  }

  #hold(until: number): void {
    this.#heldUntil = Math.max(this.#heldUntil, until);
  }
}
