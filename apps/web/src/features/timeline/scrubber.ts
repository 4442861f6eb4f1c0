/**
 * Asks the simulator for moments while a finger draws along the timeline: one at a time, and the
 * newest wish next, so that a slow machine skips moments and never queues them.
 */
import type { FromWorker, ToWorker } from "../../worker/worker-messages.ts";

interface Simulator {
  send: (message: ToWorker) => void;
  listen: (listener: (message: FromWorker) => void) => () => void;
}

export class Scrubber {
  readonly #simulator: Simulator;
  #wish: number | null = null;
  #endWait: (() => void) | null = null;

  constructor(simulator: Simulator) {
    this.#simulator = simulator;
  }

  /** Shows the moment at the end of a tick, as soon as the one before it is shown. */
  show(tick: number): void {
    if (this.#endWait !== null) {
      this.#wish = tick;
      return;
    }
    this.#simulator.send({ type: "seek", tick });
    this.#endWait = this.#simulator.listen(({ type }) => {
      if (type === "frame") this.#shown();
      // What broke shows nothing any more: who goes on drawing asks anew.
      if (type === "fault") this.stop();
    });
  }

  /** Forgets what is wished and not yet asked for, and waits for nothing any more. */
  stop(): void {
    this.#wish = null;
    this.#endWait?.();
    this.#endWait = null;
  }

  #shown(): void {
    this.#endWait?.();
    this.#endWait = null;
    const wish = this.#wish;
    this.#wish = null;
    if (wish !== null) this.show(wish);
  }
}
