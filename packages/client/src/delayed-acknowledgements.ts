/**
 * Reports arrive every 33 to 67 ms. A longer gap means the relay waited, or the page reports
 * rarely.
 */
const LATE_MS = 80;
/**
 * Tolerated difference between two gaps: the relay compensates for it, and timers are no better.
 */
const TOLERANCE_MS = 4;
/** Upper bound of one measured difference: a busy reader reads two snapshots at once. */
const MAX_DIFFERENCE_MS = 25;
/** Accumulated lateness that indicates a long round trip: less than the interval of snapshots. */
const LATENESS_LIMIT_MS = 30;
/**
 * How long to acknowledge every snapshot after a late one. Doubles with each failed attempt to
 * stop.
 */
const EVERY_MS = { first: 5_000, max: 60_000 };
/** Time without a late snapshot after which a connection counts as fast again. */
const TRUSTED_MS = 10_000;

/**
 * Decides when a reader sends `seen`. Acknowledgements are cumulative and the relay sends up to two
 * unacknowledged snapshots, so it is enough to acknowledge every second one. This saves the relay a
 * third of all incoming messages.
 *
 * With a long round trip the relay would have to wait for the acknowledgement of the second
 * snapshot, and fewer snapshots would arrive. No message shows the round trip, but the gaps between
 * snapshots do. A gap in which the relay waited follows an acknowledged snapshot and lasts one
 * round trip. The gap after it is as long as the page's interval. The reader accumulates the
 * difference between the two. If it grows, the reader acknowledges every snapshot for a while, and
 * then tries again, less often each time. It also acknowledges every snapshot of a page that
 * reports rarely.
 */
export class DelayedAcknowledgements {
  /** whether the last snapshot was acknowledged; null: none has arrived on this connection */
  #wasAcknowledged: boolean | null = null;
  #lastReadAt = 0;
  #everyUntil = -Infinity;
  #everyMs = EVERY_MS.first;
  /** the gap after the last acknowledged snapshot */
  #acknowledgedGap: number | null = null;
  /** by how much the gaps after acknowledged snapshots were longer than the others */
  #lateness = 0;

  /** To be called for a new connection, whose acknowledgements and round trip are its own. */
  reset(): void {
    this.#wasAcknowledged = null;
    this.#everyUntil = -Infinity;
    this.#everyMs = EVERY_MS.first;
    this.#resetMeasurement();
  }

  /**
   * A snapshot was read, including the one in the welcome.
   * @param now ms
   * @returns whether to acknowledge it; true for at least one of two in a row
   */
  read(now: number): boolean {
    if (this.#wasAcknowledged !== null) {
      this.#measure(now - this.#lastReadAt, this.#wasAcknowledged, now);
    }
    this.#lastReadAt = now;
    this.#wasAcknowledged = this.#wasAcknowledged !== true || now < this.#everyUntil;
    return this.#wasAcknowledged;
  }

  #measure(gap: number, wasAcknowledged: boolean, now: number): void {
    if (now < this.#everyUntil) {
      // Delayed acknowledgements would be late as well.
      if (gap > LATE_MS) this.#everyUntil = now + this.#everyMs;
      return;
    }
    if (gap > LATE_MS) return this.#acknowledgeEvery(now);
    if (now - this.#everyUntil > TRUSTED_MS) this.#everyMs = EVERY_MS.first;
    if (wasAcknowledged) {
      this.#acknowledgedGap = gap;
    } else if (this.#acknowledgedGap !== null) {
      const difference = Math.min(this.#acknowledgedGap - gap - TOLERANCE_MS, MAX_DIFFERENCE_MS);
      this.#lateness = Math.max(0, this.#lateness + difference);
      this.#acknowledgedGap = null;
      if (this.#lateness > LATENESS_LIMIT_MS) this.#acknowledgeEvery(now);
    }
  }

  #acknowledgeEvery(now: number): void {
    this.#everyUntil = now + this.#everyMs;
    this.#everyMs = Math.min(2 * this.#everyMs, EVERY_MS.max);
    this.#resetMeasurement();
  }

  #resetMeasurement(): void {
    this.#acknowledgedGap = null;
    this.#lateness = 0;
  }
}
