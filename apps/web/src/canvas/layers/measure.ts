/** The tape between two points that the reader measures: dashed, ticks every 10 cm, its length in words. */
import type { Brush } from "../brush.ts";
import type { Dirt } from "../dirt.ts";
import type { Palette } from "../palette.ts";
import { viewX, viewY, type Viewport } from "../viewport.ts";

/** A tape; points in units. */
export interface Measured {
  from: { x: number; y: number };
  to: { x: number; y: number };
  /** lines of the label, in the reader's language; none while there is only one point */
  words: readonly string[];
}

const TICK = 10;
/** Ticks closer than this many pixels would be a grey band; only every fifth is drawn then. */
const TICKS_FROM_PX = 3;
const LABEL = { font: 13, line: 18, padding: 8, gap: 10 };

/** Draws the tape and its label. */
export function drawMeasure(
  brush: Brush,
  viewport: Viewport,
  palette: Palette,
  { from, to, words }: Measured,
  dirt: Dirt,
): void {
  const x = viewX(viewport, from.x);
  const y = viewY(viewport, from.y);
  const dx = viewX(viewport, to.x) - x;
  const dy = viewY(viewport, to.y) - y;
  const length = Math.sqrt(dx * dx + dy * dy);
  dirt.addLine(x, y, x + dx, y + dy, 10);
  brush.save();
  brush.translate(x, y);
  brush.rotate(Math.atan2(dy, dx));
  brush.strokeStyle = palette.ink;
  brush.lineWidth = 2;
  brush.setLineDash([6, 4]);
  brush.beginPath();
  brush.moveTo(0, 0);
  brush.lineTo(length, 0);
  brush.stroke();
  brush.setLineDash([]);
  brush.lineWidth = 1;
  const step = TICK * viewport.scale >= TICKS_FROM_PX ? TICK : TICK * 5;
  const units = length / viewport.scale;
  brush.beginPath();
  for (let at = 0; at < units; at += step) {
    const half = at % 100 === 0 ? 8 : at % 50 === 0 ? 6 : 3;
    brush.moveTo(at * viewport.scale, -half);
    brush.lineTo(at * viewport.scale, half);
  }
  brush.moveTo(length, -8);
  brush.lineTo(length, 8);
  brush.stroke();
  brush.fillStyle = palette.ink;
  brush.beginPath();
  brush.arc(0, 0, 3.5, 0, 2 * Math.PI);
  brush.arc(length, 0, 3.5, 0, 2 * Math.PI);
  brush.fill();
  brush.restore();
  if (words.length > 0) drawLabel(brush, viewport, palette, { x: x + dx, y: y + dy }, words, dirt);
}

/** Beside the tape's end, where there is room for it. */
function drawLabel(
  brush: Brush,
  { port }: Viewport,
  palette: Palette,
  end: { x: number; y: number },
  words: readonly string[],
  dirt: Dirt,
): void {
  brush.font = `600 ${LABEL.font}px ${palette.font}`;
  const widths = words.map((line) => brush.measureText(line).width);
  const width = Math.ceil(Math.max(...widths)) + 2 * LABEL.padding;
  const height = words.length * LABEL.line + LABEL.padding;
  const right = port.x + port.width;
  const x = end.x + LABEL.gap + width <= right ? end.x + LABEL.gap : end.x - LABEL.gap - width;
  const above = end.y - LABEL.gap - height;
  const left = Math.round(Math.max(port.x, x));
  const top = Math.round(above >= port.y ? above : end.y + LABEL.gap);
  dirt.add(left, top, width, height);
  brush.beginPath();
  brush.roundRect(left + 0.5, top + 0.5, width - 1, height - 1, 6);
  brush.fillStyle = palette.surface;
  brush.fill();
  brush.strokeStyle = palette.edge;
  brush.lineWidth = 1;
  brush.stroke();
  brush.fillStyle = palette.ink;
  brush.textAlign = "left";
  brush.textBaseline = "middle";
  words.forEach((line, at) => {
    const middle = top + LABEL.padding / 2 + (at + 0.5) * LABEL.line;
    brush.fillStyle = at === 0 ? palette.ink : palette.ink2;
    brush.fillText(line, left + LABEL.padding, middle);
  });
}
