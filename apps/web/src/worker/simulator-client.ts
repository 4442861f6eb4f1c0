/** The main thread's end of the simulator worker: commands in, events out. */
import type { FromWorker, ToWorker } from "./worker-messages.ts";

/** As much of a Worker as is needed here. */
export interface WorkerPort {
  postMessage(message: ToWorker, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
}

export class SimulatorClient {
  readonly #port: WorkerPort;
  readonly #listeners = new Set<(message: FromWorker) => void>();
  #isGone = false;

  constructor(port: WorkerPort) {
    this.#port = port;
    port.onmessage = ({ data }) => this.#hear(data);
  }

  /** Whether the worker did not load or broke outside of its own care: it answers nothing any more. */
  get isGone(): boolean {
    return this.#isGone;
  }

  /** The worker is gone; everybody who listens hears of it as of a fault. */
  fail(reason: string): void {
    this.#isGone = true;
    this.#hear({ type: "fault", reason });
  }

  /** @param transfer what is handed over for good, not copied */
  send(message: ToWorker, transfer: Transferable[] = []): void {
    this.#port.postMessage(message, transfer);
  }

  /** Hands on what the worker told before anybody could listen here. */
  catchUp(messages: readonly FromWorker[]): void {
    for (const message of messages) this.#hear(message);
  }

  /** Hears every message of the worker. @returns a function that ends it */
  listen(listener: (message: FromWorker) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #hear(message: FromWorker): void {
    for (const listener of this.#listeners) listener(message);
  }
}
