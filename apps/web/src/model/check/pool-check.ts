/**
 * Runs a check on the workers of a pool. The first outcome is displayed at once, and those after it
 * together from time to time, so that the page has time to draw.
 */
import {
  checkUnitAt,
  countCheckUnits,
  type CheckJob,
  type CheckUnit,
  type MazeOutcome,
} from "@corridor/challenge";
import type { WorkerPool } from "../../simulator/worker-pool.ts";

/** Interval in ms between two updates of the page. */
export const SHOW_MS = 200;

/** Runs a function after a delay. */
export type Later = (action: () => void, milliseconds: number) => void;

export interface CheckListener {
  onOutcome: (unit: CheckUnit, outcome: MazeOutcome) => void;
  /** Displays the outcomes so far. @param done their number */
  onShow: (done: number) => void;
  /** @param reason failed: a worker did not load or failed */
  onEnd: (reason: "done" | "failed") => void;
}

export class PoolCheck {
  readonly #pool: Pick<WorkerPool, "run" | "stop">;
  readonly #later: Later;
  /** of the running check; null without one */
  #listener: CheckListener | null = null;
  #done = 0;
  #isDue = false;

  constructor(pool: Pick<WorkerPool, "run" | "stop">, later: Later) {
    this.#pool = pool;
    this.#later = later;
  }

  get isRunning(): boolean {
    return this.#listener !== null;
  }

  /**
   * Runs a check in place of the current job of the pool. A job without units ends at once.
   * @returns number of units
   */
  start(job: CheckJob, listener: CheckListener): number {
    const count = countCheckUnits(job);
    this.#pool.stop();
    this.#done = 0;
    if (count === 0) {
      listener.onEnd("done");
      return count;
    }
    this.#listener = listener;
    this.#pool.run({ kind: "check", check: job }, count, {
      onResult: (result, unit) => {
        if (result.kind !== "check") return;
        listener.onOutcome(checkUnitAt(job, unit), result.outcome);
        this.#done++;
        if (this.#done === count) this.#end("done");
        else this.#showSoon(listener);
      },
      onEnd: (reason) => {
        if (this.#listener !== listener) return;
        if (reason === "failed") this.#end("failed");
        else this.#listener = null;
      },
    });
    return count;
  }

  /** Ends the check after displaying its outcomes so far. The listener receives nothing more. */
  stop(): void {
    const listener = this.#listener;
    if (listener === null) return;
    this.#listener = null;
    this.#pool.stop();
    listener.onShow(this.#done);
  }

  #end(reason: "done" | "failed"): void {
    const listener = this.#listener;
    this.#listener = null;
    listener?.onShow(this.#done);
    listener?.onEnd(reason);
  }

  #showSoon(listener: CheckListener): void {
    if (this.#done === 1) {
      listener.onShow(this.#done);
      return;
    }
    if (this.#isDue) return;
    this.#isDue = true;
    this.#later(() => {
      this.#isDue = false;
      if (this.#listener === listener) listener.onShow(this.#done);
    }, SHOW_MS);
  }
}
