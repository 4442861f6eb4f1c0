/** What crosses between page and worker for drawing the stage. */
import type { LayerCanvases } from "../canvas/brush.ts";
import type { Scene } from "../canvas/scene.ts";
import type { Scroll } from "../canvas/viewport.ts";

export type StageToWorker =
  /** the worker draws on these canvases from now on; they are transferred. `font`: address of the page's font */
  | { type: "stage-mount"; canvases: LayerCanvases<OffscreenCanvas>; font: string }
  /** the page draws by itself, and is sent every frame for it */
  | { type: "stage-mount-here" }
  /** fields of the scene that changed; all of them after a mount */
  | { type: "stage-scene"; changes: Partial<Scene> }
  | { type: "stage-scroll"; scroll: Scroll }
  /** the canvases are gone */
  | { type: "stage-unmount" };
