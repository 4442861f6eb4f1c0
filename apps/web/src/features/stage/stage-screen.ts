/** What the stage is drawn on, wherever that is: in the simulator worker or here on the page. */
import type { Scene } from "../../canvas/scene.ts";
import type { Scroll } from "../../canvas/viewport.ts";

/** Draws what it is shown. */
export interface StageScreen {
  show(scene: Scene): void;
  scrollTo(scroll: Scroll): void;
  /** ends the drawing and takes the canvases away */
  end(): void;
}
