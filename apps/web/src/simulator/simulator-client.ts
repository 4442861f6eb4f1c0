/** The main thread's end of the simulator worker: commands in, events out. */
import type { FromWorker, ToWorker } from "./protocol/worker-messages.ts";

/** The part of a Worker that is used. */
export interface WorkerPort {
  postMessage(message: ToWorker, transfer: Transferable[]): void;
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null;
}

export class SimulatorClient {
  readonly #port: WorkerPort;
  readonly #listeners = new Set<(message: FromWorker) => void>();
  #isGone = false;
  #isResetting = false;

  constructor(port: WorkerPort) {
    this.#port = port;
    port.onmessage = ({ data }) => this.#receive(data);
  }

  /**
   * Whether the worker did not load or broke outside of its own error handling: it does not answer
   * any more.
   */
  get isGone(): boolean {
    return this.#isGone;
  }

  /** Whether frames and events are still of the run that a reset replaces. */
  get isResetting(): boolean {
    return this.#isResetting;
  }

  /** The worker is gone; all listeners receive a fault. */
  fail(reason: string): void {
    this.#isGone = true;
    this.#receive({ type: "fault", reason });
  }

  /** @param transfer objects that are transferred instead of copied */
  send(message: ToWorker, transfer: Transferable[] = []): void {
    if (message.type === "reset") this.#isResetting = true;
    this.#port.postMessage(message, transfer);
  }

  /** Delivers messages of the worker from before anybody could listen here. */
  catchUp(messages: readonly FromWorker[]): void {
    for (const message of messages) this.#receive(message);
  }

  /**
   * Subscribes to every message of the worker.
   * @returns a function that unsubscribes
   */
  listen(listener: (message: FromWorker) => void): () => void {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }

  #receive(message: FromWorker): void {
    if (message.type === "truncated" && message.after < 0) this.#isResetting = false;
    for (const listener of this.#listeners) listener(message);
  }
}
