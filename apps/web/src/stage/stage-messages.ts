/** Messages between page and worker for drawing the stage. */
import type { Snapshot } from "@corridor/protocol";
import type { Scroll } from "./drawing/viewport.ts";
import type { Frame } from "./drawing/frame.ts";
import type { LayerCanvases } from "./drawing/drawing-context.ts";
import type { StageModel } from "./layers/stage-model.ts";

export type StageToWorker =
  /**
   * the worker draws on these canvases, which are transferred. `font`: address of the page's font
   */
  | { type: "stage-mount"; canvases: LayerCanvases<OffscreenCanvas>; font: string }
  /** the page draws by itself, and receives every frame */
  | { type: "stage-mount-here" }
  /** changed fields of the stage model; all of them after a mount */
  | { type: "stage-model"; changes: Partial<StageModel> }
  /** the page displays the numbers of this snapshot from now on: the stage writes the same ones */
  | { type: "stage-numbers"; snapshot: Snapshot }
  /** the canvases were removed */
  | { type: "stage-unmount" };

export type StageFromWorker =
  /** every frame, for a page that draws the stage by itself; in addition to `frame` */
  | { type: "picture"; frame: Frame }
  /** the camera follows the robot: scroll the stage there */
  | { type: "stage-scroll-to"; scroll: Scroll };
