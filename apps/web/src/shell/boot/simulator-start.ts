/**
 * The simulator worker: the one that public/first.js started while the page's script was loading
 * or, in development, a new one. On a first visit its robot may drive already; the page then takes
 * over the existing run.
 */
import type { FromWorker } from "../../simulator/protocol/worker-messages.ts";

declare global {
  interface Window {
    corridorSimulator?: {
      worker: Worker;
      /** messages of the worker until the page listens */
      queue: readonly FromWorker[];
      /** error of the worker before the page listened; "" without a message */
      failure: string | null;
    };
  }
}

export function startSimulator(): Worker {
  return window.corridorSimulator?.worker ?? newSimulator();
}

export function newSimulator(): Worker {
  return new Worker(new URL("../../simulator/worker/simulator.worker.ts", import.meta.url), {
    type: "module",
  });
}

/** A simulator that stores no run on the device: its name is `VOLATILE`. */
export function newVolatileSimulator(): Worker {
  return new Worker(new URL("../../simulator/worker/simulator.worker.ts", import.meta.url), {
    type: "module",
    name: "volatile",
  });
}

/** Messages of the worker before the page listened. */
export function earlyMessages(): readonly FromWorker[] {
  return window.corridorSimulator?.queue ?? [];
}

/**
 * @param report receives why the worker did not load or broke outside of its own error handling; ""
 *   if unknown
 */
export function onSimulatorFailure(worker: Worker, report: (reason: string) => void): void {
  const failure = window.corridorSimulator?.failure ?? null;
  if (failure !== null) report(failure);
  worker.onerror = ({ message }) => report(message);
}
