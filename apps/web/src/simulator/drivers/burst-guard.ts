/**
 * Delays bursts of velocities: a script that queues them while a connection is broken sends them
 * all, seconds old, when it reconnects. Only the last one may move the robot.
 */

const BURST_MS = 50;
/** More velocities than this within `BURST_MS` are a burst. */
const BURST = 3;
/** A longer burst is continuous load, which must not delay the newest value for ever. */
const MAX_BURST_MS = 500;
/** After a new connection, of the page or of a script. */
const NEW_CONNECTION_MS = 100;
/** A velocity with a longer delay was queued somewhere, even without a new connection. */
const OLD_MS = 500;
/** Longest wait for a newer velocity behind an old one. */
const OLD_HELD_MS = 300;
/** A series of old velocities within this time is delayed only once. */
const OLD_SERIES_MS = 1_000;

export class BurstGuard {
  #arrivals: number[] = [];
  #heldUntil = Number.NEGATIVE_INFINITY;
  /** the page has reconnected, and no velocity has arrived since */
  #isReconnected = false;
  /** of the newest burst: its newest velocity, and the one that made it a burst */
  #burstAt = Number.NEGATIVE_INFINITY;
  #burstSince = Number.NEGATIVE_INFINITY;
  #oldAt = Number.NEGATIVE_INFINITY;
  #oldHeldUntil = Number.NEGATIVE_INFINITY;

  /** Whether a queued velocity must wait longer. */
  isHeld(now: number): boolean {
    return now < this.#heldUntil || now < this.#oldHeldUntil;
  }

  /**
   * Records a received velocity.
   * @param ageMs milliseconds since its script first tried to send it
   */
  add(now: number, ageMs: number): void {
    if (this.#isReconnected) this.#hold(now + NEW_CONNECTION_MS);
    this.#isReconnected = false;
    if (ageMs <= OLD_MS) this.#oldHeldUntil = Number.NEGATIVE_INFINITY;
    else {
      if (now - this.#oldAt > OLD_SERIES_MS) this.#oldHeldUntil = now + OLD_HELD_MS;
      this.#oldAt = now;
    }
    this.#arrivals = [...this.#arrivals.filter((at) => now - at < BURST_MS), now];
    if (this.#arrivals.length <= BURST) return;
    if (now - this.#burstAt > BURST_MS) this.#burstSince = now;
    this.#burstAt = now;
    if (now - this.#burstSince < MAX_BURST_MS) this.#hold(now + BURST_MS);
  }

  /** The page has reconnected to the relay, which may have queued velocities. */
  reconnect(): void {
    this.#isReconnected = true;
  }

  /** A script connected this long ago, and may have queued velocities itself. */
  connect(ageMs: number, now: number): void {
    this.#hold(now + NEW_CONNECTION_MS - ageMs);
  }

  #hold(until: number): void {
    this.#heldUntil = Math.max(this.#heldUntil, until);
  }
}
