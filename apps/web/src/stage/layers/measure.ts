/** The measuring tape between two points: dashed, ticks every 10 units, with a label. */
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import { viewX, viewY, type Viewport } from "../drawing/viewport.ts";

/** A measurement. Points are in units. */
export interface Measured {
  from: { x: number; y: number };
  to: { x: number; y: number };
  /** translated lines of the label; empty while there is only one point */
  words: readonly string[];
}

const TICK = 10;
/**
 * Ticks closer than this many pixels would look like a grey band; only every fifth is drawn then.
 */
const TICKS_FROM_PX = 3;
const LABEL = { font: 13, line: 18, padding: 8, gap: 10 };

/** Draws the tape and its label. */
export function drawMeasure(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  { from, to, words }: Measured,
  dirty: DirtyRects,
): void {
  const x = viewX(viewport, from.x);
  const y = viewY(viewport, from.y);
  const dx = viewX(viewport, to.x) - x;
  const dy = viewY(viewport, to.y) - y;
  const length = Math.sqrt(dx * dx + dy * dy);
  dirty.addLine(x, y, x + dx, y + dy, 10);
  context.save();
  context.translate(x, y);
  context.rotate(Math.atan2(dy, dx));
  context.strokeStyle = palette.ink;
  context.lineWidth = 2;
  context.setLineDash([6, 4]);
  context.beginPath();
  context.moveTo(0, 0);
  context.lineTo(length, 0);
  context.stroke();
  context.setLineDash([]);
  context.lineWidth = 1;
  const step = TICK * viewport.scale >= TICKS_FROM_PX ? TICK : TICK * 5;
  const units = length / viewport.scale;
  context.beginPath();
  for (let at = 0; at < units; at += step) {
    const half = at % 100 === 0 ? 8 : at % 50 === 0 ? 6 : 3;
    context.moveTo(at * viewport.scale, -half);
    context.lineTo(at * viewport.scale, half);
  }
  context.moveTo(length, -8);
  context.lineTo(length, 8);
  context.stroke();
  context.fillStyle = palette.ink;
  context.beginPath();
  context.arc(0, 0, 3.5, 0, 2 * Math.PI);
  context.arc(length, 0, 3.5, 0, 2 * Math.PI);
  context.fill();
  context.restore();
  if (words.length > 0)
    drawLabel(context, viewport, palette, { x: x + dx, y: y + dy }, words, dirty);
}

/** Draws the label beside the end of the tape, inside the port. */
function drawLabel(
  context: DrawingContext,
  { port }: Viewport,
  palette: Palette,
  end: { x: number; y: number },
  words: readonly string[],
  dirty: DirtyRects,
): void {
  context.font = `600 ${LABEL.font}px ${palette.font}`;
  const widths = words.map((line) => context.measureText(line).width);
  const width = Math.ceil(Math.max(...widths)) + 2 * LABEL.padding;
  const height = words.length * LABEL.line + LABEL.padding;
  const right = port.x + port.width;
  const x = end.x + LABEL.gap + width <= right ? end.x + LABEL.gap : end.x - LABEL.gap - width;
  const above = end.y - LABEL.gap - height;
  const left = Math.round(Math.max(port.x, x));
  const top = Math.round(above >= port.y ? above : end.y + LABEL.gap);
  dirty.add(left, top, width, height);
  context.beginPath();
  context.roundRect(left + 0.5, top + 0.5, width - 1, height - 1, 6);
  context.fillStyle = palette.surface;
  context.fill();
  context.strokeStyle = palette.edge;
  context.lineWidth = 1;
  context.stroke();
  context.fillStyle = palette.ink;
  context.textAlign = "left";
  context.textBaseline = "middle";
  words.forEach((line, at) => {
    const middle = top + LABEL.padding / 2 + (at + 0.5) * LABEL.line;
    context.fillStyle = at === 0 ? palette.ink : palette.ink2;
    context.fillText(line, left + LABEL.padding, middle);
  });
}
