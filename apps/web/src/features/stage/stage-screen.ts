/** What the stage is drawn on, wherever that is: in the simulator worker or here on the page. */
import type { StageModel } from "../../canvas/stage-model.ts";
import type { StageToWorker } from "../../worker/stage-messages.ts";
import type { FromWorker } from "../../worker/worker-messages.ts";

/** The worker that draws: the simulator's, or that of a page that looks on. */
export interface StageLink {
  /** @param transfer what is handed over for good, not copied */
  send(message: StageToWorker, transfer?: Transferable[]): void;
  /** @returns a function that ends it */
  listen(listener: (message: FromWorker) => void): () => void;
}

/** Draws what it is shown. */
export interface StageScreen {
  show(model: StageModel): void;
  /** ends the drawing and takes the canvases away */
  end(): void;
}
