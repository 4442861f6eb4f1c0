/**
 * Delays bursts of velocities: a script that queues them while a connection is broken sends them
 * all, seconds old, when it reconnects. Only the last one may move the robot.
 */

const BURST_MS = 50;
/** More velocities than this within `BURST_MS` are a burst. */
const BURST = 3;
/** A longer burst is continuous load, which must not delay the newest value for ever. */
const MAX_BURST_MS = 500;
/** Longest wait for the next velocity of a burst that arrives slowly. */
const MAX_HELD_MS = 300;
/** After a new connection, of the page or of a script. */
const NEW_CONNECTION_MS = 100;
/** A velocity with a longer delay was queued somewhere, even without a new connection. */
const OLD_MS = 500;
/** Longest wait for a newer velocity behind an old one. */
const OLD_HELD_MS = 300;
/** A series of old velocities within this time is delayed only once. */
const OLD_SERIES_MS = 1_000;

/** When a velocity arrived, in ms: here, and at the relay by the relay's clock. */
interface Arrival {
  here: number;
  atRelay: number;
}

export class BurstGuard {
  #arrivals: Arrival[] = [];
  #heldUntil = Number.NEGATIVE_INFINITY;
  /** the page has reconnected, and no velocity has arrived since */
  #isReconnected = false;
  /** the newest burst: its newest velocity, and the one that made it a burst */
  #burst: { since: Arrival; newest: Arrival } | null = null;
  #oldAt = Number.NEGATIVE_INFINITY;
  #oldHeldUntil = Number.NEGATIVE_INFINITY;

  /** Whether a queued velocity must wait longer. */
  isHeld(now: number): boolean {
    return now < this.#heldUntil || now < this.#oldHeldUntil;
  }

  /**
   * Records a received velocity.
   * @param ageMs milliseconds since its script first tried to send it
   * @param atRelay ms at which the relay received it, by its clock. The relay stores one command
   *   after the other, so a burst arrives here as slowly as its disk writes.
   */
  add(now: number, ageMs: number, atRelay: number): void {
    if (this.#isReconnected) this.#hold(now + NEW_CONNECTION_MS);
    this.#isReconnected = false;
    if (ageMs <= OLD_MS) this.#oldHeldUntil = Number.NEGATIVE_INFINITY;
    else {
      if (now - this.#oldAt > OLD_SERIES_MS) this.#oldHeldUntil = now + OLD_HELD_MS;
      this.#oldAt = now;
    }
    const arrival: Arrival = { here: now, atRelay };
    this.#arrivals = [
      ...this.#arrivals.filter((each) => between(each, arrival) < BURST_MS),
      arrival,
    ];
    if (this.#arrivals.length <= BURST) return;
    const last = this.#burst;
    const isContinued = last !== null && between(last.newest, arrival) <= BURST_MS;
    const since = isContinued ? last.since : arrival;
    this.#burst = { since, newest: arrival };
    if (between(since, arrival) >= MAX_BURST_MS) return;
    // The next one may arrive later than this one did.
    const gap = now - (this.#arrivals.at(-2)?.here ?? now);
    this.#hold(now + Math.min(MAX_HELD_MS, Math.max(BURST_MS, 3 * gap)));
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

/** ms between two arrivals, where they were closer. */
function between(earlier: Arrival, later: Arrival): number {
  return Math.min(later.here - earlier.here, later.atRelay - earlier.atRelay);
}
