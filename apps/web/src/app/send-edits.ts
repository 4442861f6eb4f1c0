/**
 * Every change of the documents on the screen goes to the worker. Those that it told itself, with a run
 * that was just opened, go back to it as well: it knows by their content that they are no edit, whatever
 * else was edited while they were on their way.
 */
import type { WorkspaceStore } from "../stores/workspace-store.ts";
import type { SimulatorClient } from "../worker/simulator-client.ts";

/** Begins with the next change; the first documents are the `load` message's. */
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
