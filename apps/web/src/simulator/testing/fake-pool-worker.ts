import type { FromPoolWorker, PoolPort, ToPoolWorker } from "../protocol/pool-messages.ts";
import { runUnit } from "../pool-worker/run-unit.ts";
import { UnitQueue } from "../pool-worker/unit-queue.ts";

/** A worker that completes its units on request. */
export class FakePoolWorker implements PoolPort {
  onmessage: PoolPort["onmessage"] = null;
  onerror: PoolPort["onerror"] = null;
  isOver = false;
  #now = 0;
  readonly #queue = new UnitQueue({
    run: runUnit,
    post: (data) => this.onmessage?.({ data } as MessageEvent<FromPoolWorker>),
    // Each slice contains one unit.
    now: () => (this.#now += 1_000),
  });

  /** number of pending units */
  get waiting(): number {
    return this.#queue.size;
  }

  postMessage(message: ToPoolWorker): void {
    this.#queue.receive(message);
  }

  terminate(): void {
    this.isOver = true;
  }

  /**
   * Completes the oldest unit.
   * @returns whether there was one
   */
  answer(): boolean {
    const isBusy = this.waiting > 0;
    this.#queue.runSlice();
    return isBusy;
  }
}
