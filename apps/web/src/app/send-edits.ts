/**
 * Every change of the documents on the screen goes to the worker, but for those that it told itself:
 * the ones that a run ended with which was just opened are no edit of that run.
 */
import type { WorkspaceStore } from "../stores/workspace-store.ts";
import type { FromWorker, ToWorker } from "../worker/worker-messages.ts";

interface Simulator {
  send: (message: ToWorker) => void;
  listen: (listener: (message: FromWorker) => void) => () => void;
}

/** Begins with the next change; the first documents are the `load` message's. */
export function sendEdits(workspace: WorkspaceStore, simulator: Simulator): void {
  let known: { maze: unknown; program: unknown } | null = null;
  simulator.listen((message) => {
    if (message.type === "run-loaded") known = message.loaded.ok ? message.loaded : null;
  });
  workspace.subscribe((next, before) => {
    const told = known;
    known = null;
    if (next.maze !== before.maze && !isSame(next.maze, told?.maze)) {
      simulator.send({ type: "edit-maze", maze: next.maze });
    }
    if (next.program !== before.program && !isSame(next.program, told?.program)) {
      simulator.send({ type: "edit-program", program: next.program });
    }
  });
}

/** A work of the shelf may hold the very same document; parsed ones have their fields in one order. */
function isSame(document: unknown, told: unknown): boolean {
  return told !== undefined && JSON.stringify(document) === JSON.stringify(told);
}
