/** One canvas of the stage, whose unit is the CSS pixel whatever the screen's density. */
import type { Brush, LayerCanvas } from "./brush.ts";
import { Dirt } from "./dirt.ts";
import type { Scene } from "./scene.ts";
import type { Box } from "./viewport.ts";

/** Pixels around that part in which outlines of the frame may still show. */
const OUTLINE = 2;

export class Surface {
  readonly brush: Brush;
  /** what has been drawn on since it was last empty; only layers that are wiped in part keep it */
  readonly dirt = new Dirt();
  readonly #canvas: LayerCanvas;

  constructor(canvas: LayerCanvas) {
    const brush = canvas.getContext("2d");
    if (brush === null) throw new Error("This browser gives no 2D canvas.");
    this.brush = brush;
    this.#canvas = canvas;
  }

  /** Empties the canvas, and gives it the size of the scene. */
  renew({ layout: { view }, pixelRatio }: Scene): void {
    this.#fit(view, pixelRatio);
    this.brush.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    this.brush.clearRect(0, 0, view.width, view.height);
    this.dirt.forget();
  }

  /** Empties only what was drawn on, where the size is still right. */
  wipe(scene: Scene): void {
    const { layout, pixelRatio } = scene;
    if (this.#fit(layout.view, pixelRatio)) this.dirt.forget();
    this.dirt.wipe(this.brush, pixelRatio, layout.view);
  }

  /** Draws inside a part of the view only, so that a maze that is scrolled stays off the rulers. */
  clipped<Result>({ x, y, width, height }: Box, draw: () => Result): Result {
    const { brush } = this;
    brush.save();
    brush.beginPath();
    brush.rect(x - OUTLINE, y - OUTLINE, width + 2 * OUTLINE, height + 2 * OUTLINE);
    brush.clip();
    const result = draw();
    brush.restore();
    return result;
  }

  /** @returns whether the size changed, which empties a canvas */
  #fit(view: { width: number; height: number }, pixelRatio: number): boolean {
    const width = Math.round(view.width * pixelRatio);
    const height = Math.round(view.height * pixelRatio);
    if (this.#canvas.width === width && this.#canvas.height === height) return false;
    this.#canvas.width = width;
    this.#canvas.height = height;
    return true;
  }
}
