/** The drawing of the stage, in the simulator worker or on the page. */
import type { StageModel } from "../../canvas/stage-model.ts";
import type { StageToWorker } from "../../worker/stage-messages.ts";
import type { FromWorker } from "../../worker/worker-messages.ts";

/** The worker that draws: the simulator's, or that of a viewer's page. */
export interface StageLink {
  /** @param transfer objects that are transferred, not copied */
  send(message: StageToWorker, transfer?: Transferable[]): void;
  /** @returns a function that removes the listener */
  listen(listener: (message: FromWorker) => void): () => void;
}

export interface StageScreen {
  show(model: StageModel): void;
  /** ends the drawing and removes the canvases */
  end(): void;
}
