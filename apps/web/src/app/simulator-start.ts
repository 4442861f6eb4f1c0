/**
 * The simulator worker: the one that public/first.js has started while the page's script was still on
 * its way; where it has not, since Corridor is being developed, one that is started now. On a first
 * visit its robot may drive already: then the page takes over what there is.
 */
import type { FromWorker } from "../worker/worker-messages.ts";

declare global {
  interface Window {
    corridorSimulator?: {
      worker: Worker;
      /** what the worker told until the page listens */
      heard: readonly FromWorker[];
      /** what the worker said when it broke before anybody could be told; "" if nothing */
      failure: string | null;
    };
  }
}

export function startSimulator(): Worker {
  return (
    window.corridorSimulator?.worker ??
    new Worker(new URL("../worker/simulator.worker.ts", import.meta.url), { type: "module" })
  );
}

/** What the worker told before the page listened. */
export function heardBefore(): readonly FromWorker[] {
  return window.corridorSimulator?.heard ?? [];
}

/** @param tell hears why the worker did not load or broke outside of its own care, "" if nobody knows */
export function onSimulatorFailure(worker: Worker, tell: (reason: string) => void): void {
  const failure = window.corridorSimulator?.failure ?? null;
  if (failure !== null) tell(failure);
  worker.onerror = ({ message }) => tell(message);
}
