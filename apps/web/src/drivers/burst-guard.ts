/**
 * Keeps velocities back that come all at once: whoever queues them while a line is broken sends them in
 * one burst, seconds old, when it is back. Of those only the last may move the robot.
 */

const BURST_MS = 50;
/** More velocities than this within `BURST_MS` are a burst. */
const BURST = 3;
/** A burst that lasts longer is a flood, which must not keep the robot from its newest value for ever. */
const LONGEST_BURST_MS = 500;
/** After a new line, of the page or of a script. */
const NEW_LINE_MS = 100;
/** A velocity that took so long to come was kept somewhere, though no line is known to be new. */
const OLD_MS = 500;
/** So long the newest one may take to come behind it. */
const OLD_HELD_MS = 300;
/** Old ones that follow each other more closely are held up once. */
const OLD_SPELL_MS = 1_000;

export class BurstGuard {
  #arrivals: number[] = [];
  #heldUntil = Number.NEGATIVE_INFINITY;
  /** the page's own line is new, and nothing has come over it yet */
  #isLineNew = false;
  /** of the newest burst: its newest velocity, and the one that made it a burst */
  #burstAt = Number.NEGATIVE_INFINITY;
  #burstSince = Number.NEGATIVE_INFINITY;
  #oldAt = Number.NEGATIVE_INFINITY;
  #oldHeldUntil = Number.NEGATIVE_INFINITY;

  /** Whether a velocity that waits must go on waiting. */
  isHeld(now: number): boolean {
    return now < this.#heldUntil || now < this.#oldHeldUntil;
  }

  /** A velocity came. @param ageMs since its script tried to send it first */
  came(now: number, ageMs: number): void {
    if (this.#isLineNew) this.#hold(now + NEW_LINE_MS);
    this.#isLineNew = false;
    if (ageMs <= OLD_MS) this.#oldHeldUntil = Number.NEGATIVE_INFINITY;
    else {
      if (now - this.#oldAt > OLD_SPELL_MS) this.#oldHeldUntil = now + OLD_HELD_MS;
      this.#oldAt = now;
    }
    this.#arrivals = [...this.#arrivals.filter((at) => now - at < BURST_MS), now];
    if (this.#arrivals.length <= BURST) return;
    if (now - this.#burstAt > BURST_MS) this.#burstSince = now;
    this.#burstAt = now;
    if (now - this.#burstSince < LONGEST_BURST_MS) this.#hold(now + BURST_MS);
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
