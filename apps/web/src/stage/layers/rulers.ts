/** Rulers along the top and the left, in the same units as the program's numbers. */
import { CELL } from "@corridor/maze";
import type { VectorContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import { viewX, viewY, type Viewport } from "../drawing/viewport.ts";

/** Room in pixels that a number needs along its ruler. */
const NUMBER_ROOM_TOP = 44;
const NUMBER_ROOM_LEFT = 24;
const steps = [1, 2, 5, 10, 20, 50, 100];

/** Number of cells between two numbers, so that numbers never touch. */
export function numberStep(cellPx: number, room: number): number {
  return steps.find((step) => step * cellPx >= room) ?? 100;
}

/** Draws both rulers beside the port. */
export function drawRulers(context: VectorContext, viewport: Viewport, palette: Palette): void {
  const { port, columns, rows } = viewport;
  const cellPx = viewport.scale * CELL;
  context.font = `500 11px ${palette.font}`;
  context.fillStyle = palette.ink3;
  context.strokeStyle = palette.ink3;
  context.lineWidth = 1;
  context.beginPath();

  context.textAlign = "center";
  context.textBaseline = "alphabetic";
  const stepX = numberStep(cellPx, NUMBER_ROOM_TOP);
  for (let half = 0; half <= columns * 2; half++) {
    const x = viewX(viewport, (half * CELL) / 2);
    if (x < port.x - 1 || x > port.x + port.width + 1) continue;
    const isNumber = half % (2 * stepX) === 0;
    if (half % 2 === 1 && cellPx < NUMBER_ROOM_TOP) continue;
    context.moveTo(x, port.y - 4);
    context.lineTo(x, port.y - (isNumber ? 9 : 7));
    if (isNumber) context.fillText(String((half * CELL) / 2), x, port.y - 14);
  }

  context.textAlign = "right";
  context.textBaseline = "middle";
  const stepY = numberStep(cellPx, NUMBER_ROOM_LEFT);
  for (let half = 0; half <= rows * 2; half++) {
    const y = viewY(viewport, (half * CELL) / 2);
    if (y < port.y - 1 || y > port.y + port.height + 1) continue;
    const isNumber = half % (2 * stepY) === 0;
    if (half % 2 === 1 && cellPx < NUMBER_ROOM_TOP) continue;
    context.moveTo(port.x - 4, y);
    context.lineTo(port.x - (isNumber ? 11 : 7), y);
    if (isNumber) context.fillText(String((half * CELL) / 2), port.x - 15, y + 0.5);
  }
  context.stroke();
}

/** Marks the robot's position on both rulers. */
export function drawRulerMarks(
  context: VectorContext,
  viewport: Viewport,
  palette: Palette,
  pose: { x: number; y: number },
  dirty: DirtyRects,
): void {
  const { port } = viewport;
  const x = viewX(viewport, pose.x);
  const y = viewY(viewport, pose.y);
  context.fillStyle = palette.live;
  if (x >= port.x && x <= port.x + port.width) {
    dirty.add(x - 5, port.y - 12, 10, 8);
    triangle(context, x, port.y - 4, -5, -8, 5, -8);
  }
  if (y >= port.y && y <= port.y + port.height) {
    dirty.add(port.x - 12, y - 5, 8, 10);
    triangle(context, port.x - 4, y, -8, -5, -8, 5);
  }
}

function triangle(
  context: VectorContext,
  x: number,
  y: number,
  ax: number,
  ay: number,
  bx: number,
  by: number,
): void {
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + ax, y + ay);
  context.lineTo(x + bx, y + by);
  context.closePath();
  context.fill();
}
