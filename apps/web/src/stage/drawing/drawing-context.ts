/**
 * The subset of a 2D canvas that the stage needs. The types of the page and of the worker share no
 * class for it, but they share these parts, so one renderer draws in both.
 */

/** The subset of `CanvasRenderingContext2D` and `OffscreenCanvasRenderingContext2D` for drawing. */
export interface DrawingContext
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

/** The subset for the layers of the whole maze, small enough for an SVG export to implement. */
export type VectorContext = Pick<
  DrawingContext,
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

/** A canvas of the page, or an OffscreenCanvas. */
export interface LayerCanvas {
  /** device pixels */
  width: number;
  height: number;
  getContext(kind: "2d"): DrawingContext | null;
}

/** The three canvases, back to front. */
export interface LayerCanvases<Canvas = LayerCanvas> {
  maze: Canvas;
  trail: Canvas;
  live: Canvas;
}
