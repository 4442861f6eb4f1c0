import type { Snapshot } from "@corridor/protocol";
import { ClientError } from "./client-error.ts";
import type { Clock } from "./platform.ts";

const PAGE_CLOSED = "The robot's page is closed or not connected";
const REOPEN =
  "Open the page again and choose Remote. If it says Off, press Connect. If you closed its tab, copy the new address into the script.";

interface Waiter {
  isNewer: (snapshot: Snapshot) => boolean;
  resolve(snapshot: Snapshot | null): void;
}

/** Holds the newest snapshot of a robot, and resolves calls that wait for a newer one. */
export class SnapshotInbox {
  readonly #clock: Clock;
  readonly #warn: (text: string) => void;
  #newest: Snapshot | null = null;
  #lastReturned = -1;
  #waiters: Waiter[] = [];
  #end: ClientError | null = null;

  /** @param warn prints that a call waits for the page */
  constructor(clock: Clock, warn: (text: string) => void) {
    this.#clock = clock;
    this.#warn = warn;
  }

  /** null before the first */
  get newest(): Snapshot | null {
    return this.#newest;
  }

  put(snapshot: Snapshot): void {
    this.#newest = snapshot;
    const due = this.#waiters.filter(({ isNewer }) => isNewer(snapshot));
    this.#waiters = this.#waiters.filter((waiter) => !due.includes(waiter));
    for (const waiter of due) waiter.resolve(snapshot);
  }

  /**
   * A snapshot that no earlier call has returned. If the page is closed, this waits for it, because
   * the last snapshot is out of date.
   * @param timeout in ms
   * @throws ClientError robot-gone after the timeout, or the reason why the client was closed
   */
  async next(timeout: number): Promise<Snapshot> {
    let cancelTimer: () => void = () => undefined;
    let isReported = false;
    const isNew = ({ seq, state }: Snapshot): boolean => {
      if (state === "gone" && !isReported) {
        this.#warn(`${PAGE_CLOSED}. ${REOPEN} Waiting for the page.`);
        isReported = true;
      }
      return seq > this.#lastReturned && state !== "gone";
    };
    const timedOut = new Promise<null>((resolve) => {
      cancelTimer = this.#clock.after(timeout, () => resolve(null));
    });
    const snapshot = await Promise.race([this.#once(isNew), timedOut]);
    cancelTimer();
    if (this.#end !== null) throw this.#end;
    if (snapshot === null) {
      throw this.#newest?.state === "gone" ? pageClosed() : silent();
    }
    this.#lastReturned = Math.max(this.#lastReturned, snapshot.seq);
    return snapshot;
  }

  /**
   * The next snapshot that is newer than `read` or has another `state`; null once the client is
   * closed. If the page is closed or sleeps, the relay sends the last snapshot again, with another
   * `state`.
   */
  changedFrom(read: Snapshot | null): Promise<Snapshot | null> {
    return this.#once(
      ({ seq, state }) =>
        read === null || seq > read.seq || (seq === read.seq && state !== read.state),
    );
  }

  #once(isNewer: Waiter["isNewer"]): Promise<Snapshot | null> {
    if (this.#end !== null) return Promise.resolve(null);
    if (this.#newest !== null && isNewer(this.#newest)) return Promise.resolve(this.#newest);
    return new Promise((resolve) => this.#waiters.push({ isNewer, resolve }));
  }

  /** Ends all waiting calls. */
  close(reason: ClientError): void {
    this.#end = reason;
    for (const waiter of this.#waiters) waiter.resolve(null);
    this.#waiters = [];
  }
}

function pageClosed(): ClientError {
  return new ClientError("robot-gone", PAGE_CLOSED, REOPEN);
}

function silent(): ClientError {
  return new ClientError(
    "robot-gone",
    "The robot does not report",
    "Check that its page is open, connected under Remote, and not asleep.",
  );
}
