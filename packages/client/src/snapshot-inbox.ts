/** The newest snapshot of a robot, and whoever waits for a newer one. */
import type { Snapshot } from "@corridor/protocol";
import { ClientError } from "./client-error.ts";
import type { Clock } from "./platform.ts";

interface Waiter {
  isNews: (snapshot: Snapshot) => boolean;
  resolve(snapshot: Snapshot | null): void;
}

export class SnapshotInbox {
  readonly #clock: Clock;
  #newest: Snapshot | null = null;
  #given = -1;
  #waiters: Waiter[] = [];
  #end: ClientError | null = null;

  constructor(clock: Clock) {
    this.#clock = clock;
  }

  /** null until there is one */
  get newest(): Snapshot | null {
    return this.#newest;
  }

  put(snapshot: Snapshot): void {
    this.#newest = snapshot;
    const due = this.#waiters.filter(({ isNews }) => isNews(snapshot));
    this.#waiters = this.#waiters.filter((waiter) => !due.includes(waiter));
    for (const waiter of due) waiter.resolve(snapshot);
  }

  /**
   * A snapshot that no earlier call of this method has given.
   * @param patience ms to wait for it
   * @throws ClientError robot-gone when none comes, or the reason why the client has ended
   */
  async next(patience: number): Promise<Snapshot> {
    let cancelTimer: () => void = () => undefined;
    const tooLate = new Promise<null>((resolve) => {
      cancelTimer = this.#clock.after(patience, () => resolve(null));
    });
    const snapshot = await Promise.race([this.#once(({ seq }) => seq > this.#given), tooLate]);
    cancelTimer();
    if (this.#end !== null) throw this.#end;
    if (snapshot === null) {
      throw new ClientError(
        "robot-gone",
        "The robot does not report",
        "Check that its page is open, connected under Remote, and not asleep.",
      );
    }
    this.#given = Math.max(this.#given, snapshot.seq);
    return snapshot;
  }

  /**
   * The newest snapshot once it says something else than one that was read; null when the client has ended. A robot whose
   * page is closed or asleep reports nothing newer: the relay sends its last snapshot again, with another `state`.
   */
  changedFrom(read: Snapshot | null): Promise<Snapshot | null> {
    return this.#once(
      ({ seq, state }) =>
        read === null || seq > read.seq || (seq === read.seq && state !== read.state),
    );
  }

  #once(isNews: Waiter["isNews"]): Promise<Snapshot | null> {
    if (this.#end !== null) return Promise.resolve(null);
    if (this.#newest !== null && isNews(this.#newest)) return Promise.resolve(this.#newest);
    return new Promise((resolve) => this.#waiters.push({ isNews, resolve }));
  }

  /** Lets everyone go who waits. */
  close(reason: ClientError): void {
    this.#end = reason;
    for (const waiter of this.#waiters) waiter.resolve(null);
    this.#waiters = [];
  }
}
