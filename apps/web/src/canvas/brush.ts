/**
 * As much of a 2D canvas as the stage needs. The types of the page and of the worker have no class for
 * it in common, but they share these parts, so that one renderer draws in either.
 */

/** What is drawn with. */
export interface Brush
  extends
    CanvasCompositing,
    CanvasDrawPath,
    CanvasFillStrokeStyles,
    CanvasPath,
    CanvasPathDrawingStyles,
    CanvasRect,
    CanvasState,
    CanvasText,
    CanvasTextDrawingStyles,
    CanvasTransform {}

/** What the layers of the whole maze draw with: little enough that an SVG file can be drawn with it too. */
export type Pen = Pick<
  Brush,
  | "beginPath"
  | "closePath"
  | "fill"
  | "fillRect"
  | "fillStyle"
  | "fillText"
  | "font"
  | "lineCap"
  | "lineJoin"
  | "lineTo"
  | "lineWidth"
  | "moveTo"
  | "restore"
  | "rotate"
  | "roundRect"
  | "save"
  | "scale"
  | "setLineDash"
  | "stroke"
  | "strokeStyle"
  | "textAlign"
  | "textBaseline"
  | "translate"
>;

/** What is drawn on: a canvas of the page, or an OffscreenCanvas. */
export interface LayerCanvas {
  /** device pixels */
  width: number;
  height: number;
  getContext(kind: "2d"): Brush | null;
}

/** The three canvases, back to front. */
export interface LayerCanvases<Canvas = LayerCanvas> {
  maze: Canvas;
  trail: Canvas;
  live: Canvas;
}
