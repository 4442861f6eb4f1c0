/**
 * Sends seek requests while the user drags along the timeline: one at a time, and the newest tick
 * next. A slow machine skips ticks instead of queueing them.
 */
import type { FromWorker, ToWorker } from "../../simulator/protocol/worker-messages.ts";

interface Simulator {
  send: (message: ToWorker) => void;
  listen: (listener: (message: FromWorker) => void) => () => void;
}

export class Scrubber {
  readonly #simulator: Simulator;
  #target: number | null = null;
  #endWait: (() => void) | null = null;

  constructor(simulator: Simulator) {
    this.#simulator = simulator;
  }

  /** Displays the end of a tick, as soon as the previous request is done. */
  show(tick: number): void {
    if (this.#endWait !== null) {
      this.#target = tick;
      return;
    }
    this.#simulator.send({ type: "seek", tick });
    this.#endWait = this.#simulator.listen(({ type }) => {
      if (type === "frame") this.#shown();
      // After a fault the request has no response. Further drags send new requests.
      if (type === "fault") this.stop();
    });
  }

  /** Discards the pending tick, and stops waiting for the current request. */
  stop(): void {
    this.#target = null;
    this.#endWait?.();
    this.#endWait = null;
  }

  #shown(): void {
    this.#endWait?.();
    this.#endWait = null;
    const target = this.#target;
    this.#target = null;
    if (target !== null) this.show(target);
  }
}
