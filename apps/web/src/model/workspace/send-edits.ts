/**
 * Sends every change of the workspace's documents to the worker. Documents that came from the
 * worker with an opened run are sent back, too: the worker compares their content and ignores them,
 * whatever else was edited meanwhile.
 */
import type { WorkspaceStore } from "./workspace-store.ts";
import type { SimulatorClient } from "../../simulator/simulator-client.ts";

/** Starts with the next change; the first documents are part of the `load` message. */
export function sendEdits(
  workspace: WorkspaceStore,
  simulator: Pick<SimulatorClient, "send">,
): void {
  workspace.subscribe((next, before) => {
    if (next.maze !== before.maze) simulator.send({ type: "edit-maze", maze: next.maze });
    if (next.program !== before.program) {
      simulator.send({ type: "edit-program", program: next.program });
    }
  });
}
