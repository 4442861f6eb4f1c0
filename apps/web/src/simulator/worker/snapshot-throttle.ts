/** Throttles the snapshots for the relay: frequent while the robot changes, rare while it rests. */

/** Least milliseconds between two snapshots of a robot that changes. */
const INTERVAL_MS = 50;
/** Milliseconds between two snapshots of a robot at rest. */
const HEARTBEAT_MS = 1000;

export class SnapshotThrottle {
  readonly #now: () => number;
  #hasChanged = false;
  #sentAt = Number.NEGATIVE_INFINITY;

  /** @param now monotonic milliseconds */
  constructor(now: () => number) {
    this.#now = now;
  }

  /** The robot differs from the last snapshot. */
  changed(): void {
    this.#hasChanged = true;
  }

  /** Whether a snapshot is due now, which counts as sent then. */
  take(): boolean {
    const now = this.#now();
    if (now - this.#sentAt < (this.#hasChanged ? INTERVAL_MS : HEARTBEAT_MS)) return false;
    this.#sentAt = now;
    this.#hasChanged = false;
    return true;
  }
}
