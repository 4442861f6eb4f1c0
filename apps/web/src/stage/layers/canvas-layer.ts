/** One canvas of the stage, measured in CSS pixels at every pixel density. */
import type { DrawingContext, LayerCanvas } from "../drawing/drawing-context.ts";
import { DirtyRects } from "../drawing/dirty-rects.ts";
import type { StageModel } from "./stage-model.ts";
import type { Box } from "../drawing/viewport.ts";

/** Pixels around a clipped part in which outlines of the frame may still show. */
const OUTLINE = 2;

export class CanvasLayer {
  readonly context: DrawingContext;
  /** Areas drawn since the canvas was last empty. Only layers that erase partially use it. */
  readonly dirty = new DirtyRects();
  readonly #canvas: LayerCanvas;

  constructor(canvas: LayerCanvas) {
    const context = canvas.getContext("2d");
    if (context === null) throw new Error("This browser gives no 2D canvas.");
    this.context = context;
    this.#canvas = canvas;
  }

  /** Empties the canvas and resizes it to the stage model. */
  reset({ layout: { view }, pixelRatio }: StageModel): void {
    this.#fit(view, pixelRatio);
    this.context.setTransform(pixelRatio, 0, 0, pixelRatio, 0, 0);
    this.context.clearRect(0, 0, view.width, view.height);
    this.dirty.reset();
  }

  /** Erases the dirty rectangles, or the whole canvas after a resize. */
  erase(model: StageModel): void {
    const { layout, pixelRatio } = model;
    if (this.#fit(layout.view, pixelRatio)) this.dirty.reset();
    this.dirty.erase(this.context, pixelRatio, layout.view);
  }

  /** Draws clipped to a part of the view, so that a scrolled maze does not cover the rulers. */
  clipped<Result>({ x, y, width, height }: Box, draw: () => Result): Result {
    const { context } = this;
    context.save();
    context.beginPath();
    context.rect(x - OUTLINE, y - OUTLINE, width + 2 * OUTLINE, height + 2 * OUTLINE);
    context.clip();
    const result = draw();
    context.restore();
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
