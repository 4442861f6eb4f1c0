/**
 * The simulator worker: the one that public/first.js has started while the page's script was still on
 * its way; where it has not, since Corridor is being developed, one that is started now.
 */

declare global {
  interface Window {
    /** `failure`: what the worker said when it broke before anybody could be told; "" if nothing */
    corridorSimulator?: { worker: Worker; failure: string | null };
  }
}

export function startSimulator(): Worker {
  return (
    window.corridorSimulator?.worker ??
    new Worker(new URL("../worker/simulator.worker.ts", import.meta.url), { type: "module" })
  );
}

/** @param tell hears why the worker did not load or broke outside of its own care, "" if nobody knows */
export function onSimulatorFailure(worker: Worker, tell: (reason: string) => void): void {
  const failure = window.corridorSimulator?.failure ?? null;
  if (failure !== null) tell(failure);
  worker.onerror = ({ message }) => tell(message);
}
