/** The drawing of the stage, in the simulator worker or on the page. */
import type { StageModel } from "../layers/stage-model.ts";
import type { StageToWorker } from "../stage-messages.ts";
import type { FromWorker } from "../../simulator/protocol/worker-messages.ts";

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
