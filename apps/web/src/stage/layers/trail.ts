/**
 * The trail: a broad line with a dot every 25 units.
 *
 * Dots are at round coordinates, not at round distances. A robot that drives the same corridor
 * again puts them onto the old ones, and a dot is a position in the maze.
 */
import type { VectorContext } from "../drawing/drawing-context.ts";
import type { Palette } from "../drawing/palette.ts";
import type { Points } from "../drawing/trail.ts";
import { viewX, viewY, type Viewport } from "../drawing/viewport.ts";

/** Units between dots. */
const DOT_EVERY = 25;
/** Below this many pixels between dots they would look like a second line. */
const DOTS_FROM_PX = 6;

/** Numbers in a trail that is long enough to cross itself many times. */
const LAPS_FROM = 400;
/** Segments per stroke: one path of thousands of crossing segments takes far longer. */
const BATCH = 100;

/** Width of the line in pixels at a scale. */
function widthAt(scale: number): number {
  return Math.min(7, Math.max(3, 7 * scale));
}

/**
 * Draws a piece of the trail over the existing one.
 * @param points x and y alternating, in units
 * @param cap "round" for the whole trail; "butt" for a continued piece, whose round start would
 *   cover the last dots
 */
export function drawTrail(
  context: VectorContext,
  viewport: Viewport,
  palette: Palette,
  points: Points,
  cap: "round" | "butt",
): void {
  const { port } = viewport;
  const width = widthAt(viewport.scale);
  const hasDots = DOT_EVERY * viewport.scale >= DOTS_FROM_PX;
  const dots: number[] = [];
  const columns = Math.ceil(port.width) + 1;
  const hasLaps = hasDots && points.length > LAPS_FROM;
  const marked = new Uint8Array(hasLaps ? columns * (Math.ceil(port.height) + 1) : 0);
  // Laps put their dots onto the same positions, so each pixel gets only one. None is needed
  // outside of the port.
  const put = (x: number, y: number): void => {
    const atX = viewX(viewport, x);
    const atY = viewY(viewport, y);
    if (atX < port.x || atX > port.x + port.width) return;
    if (atY < port.y || atY > port.y + port.height) return;
    const pixel = Math.floor(atY - port.y) * columns + Math.floor(atX - port.x);
    if (marked[pixel] === 1) return;
    marked[pixel] = 1;
    dots.push(atX, atY);
  };
  context.lineCap = cap;
  context.lineJoin = "round";
  context.lineWidth = width;
  context.strokeStyle = palette.liveSoft;
  let isPenDown = false;
  let count = 0;
  context.beginPath();
  for (let at = 0; at + 3 < points.length; at += 2) {
    const x0 = points[at] ?? 0;
    const y0 = points[at + 1] ?? 0;
    const x1 = points[at + 2] ?? 0;
    const y1 = points[at + 3] ?? 0;
    const fromX = viewX(viewport, x0);
    const fromY = viewY(viewport, y0);
    const toX = viewX(viewport, x1);
    const toY = viewY(viewport, y1);
    const isOutside =
      Math.max(fromX, toX) < port.x - width ||
      Math.min(fromX, toX) > port.x + port.width + width ||
      Math.max(fromY, toY) < port.y - width ||
      Math.min(fromY, toY) > port.y + port.height + width;
    if (isOutside) {
      isPenDown = false;
      continue;
    }
    if (!isPenDown) context.moveTo(fromX, fromY);
    isPenDown = true;
    context.lineTo(toX, toY);
    if (hasDots) eachDot(x0, y0, x1, y1, put);
    if (++count % BATCH === 0) {
      context.stroke();
      context.beginPath();
      isPenDown = false;
    }
  }
  context.stroke();

  const size = width < 5 ? 1.5 : 2;
  context.fillStyle = palette.liveInk;
  for (let at = 0; at + 1 < dots.length; at += 2) {
    context.fillRect((dots[at] ?? 0) - size / 2, (dots[at + 1] ?? 0) - size / 2, size, size);
  }
}

/**
 * Visits every point of a segment whose coordinate along the segment's longer axis is a multiple of
 * 25. Every segment that touches a dot at its end visits it, so that the next piece covers none.
 */
export function eachDot(
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  visit: (x: number, y: number) => void,
): void {
  const isWide = Math.abs(x1 - x0) >= Math.abs(y1 - y0);
  const [from, to, crossFrom, crossTo] = isWide ? [x0, x1, y0, y1] : [y0, y1, x0, x1];
  if (from === to) return;
  const low = Math.ceil(Math.min(from, to) / DOT_EVERY);
  const high = Math.floor(Math.max(from, to) / DOT_EVERY);
  for (let number = low; number <= high; number++) {
    const along = number * DOT_EVERY;
    const across = crossFrom + ((along - from) / (to - from)) * (crossTo - crossFrom);
    if (isWide) visit(along, across);
    else visit(across, along);
  }
}
