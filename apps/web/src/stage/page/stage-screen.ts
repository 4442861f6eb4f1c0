/** The drawing of the stage, in the simulator worker or on the page. */
import type { StageModel } from "../layers/stage-model.ts";
import type { Frame } from "../drawing/frame.ts";
import type { StageFromWorker, StageToWorker } from "../stage-messages.ts";

/** A frame for the panels. The stage writes the same numbers. */
export interface PanelFrame {
  type: "frame";
  frame: Frame;
}

/** The worker that draws: the simulator's, or that of a viewer's page. */
export interface StageLink {
  /** @param transfer objects that are transferred, not copied */
  send(message: StageToWorker, transfer?: Transferable[]): void;
  /**
   * Listens to the messages for the stage, and to the frames for the panels.
   * @returns a function that removes the listener
   */
  listen(listener: (message: StageFromWorker | PanelFrame) => void): () => void;
}

export interface StageScreen {
  show(model: StageModel): void;
  /** ends the drawing and removes the canvases */
  end(): void;
}
