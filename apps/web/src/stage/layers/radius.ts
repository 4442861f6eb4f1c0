/**
 * The robot's radius at a bump: a thin circle, and a measure from the centre to the contact point.
 * It shows why a robot bumps although its beam misses a corner: the beam is thin, the robot is 50
 * units wide.
 */
import { ROBOT_RADIUS } from "@corridor/simulation";
import type { MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import { placeLabels, readingCentres, type Beam } from "../drawing/label-placement.ts";
import { viewX, viewY, type Box, type Viewport } from "../drawing/viewport.ts";
import { touchOf } from "./bumps.ts";
import { robotBox } from "./robot.ts";

const LABEL = { width: 22, height: 16, font: 12 };
/** Pixels: half the length of the bar at the contact point, and the radius of a corner's dot. */
const BAR = 5;
const DOT = 4;

/** @returns the measure; null if the robot touches nothing any more */
export function drawRadius(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  maze: MazeDocument,
  pose: Pose,
  dirty: DirtyRects,
): Beam | null {
  const contact = touchOf(maze, pose);
  if (contact === null) return null;
  const x = viewX(viewport, pose.x);
  const y = viewY(viewport, pose.y);
  const endX = viewX(viewport, contact.x);
  const endY = viewY(viewport, contact.y);
  const length = Math.hypot(endX - x, endY - y);
  const dx = (endX - x) / length;
  const dy = (endY - y) / length;
  const radius = ROBOT_RADIUS * viewport.scale;
  dirty.add(x - radius - BAR, y - radius - BAR, 2 * (radius + BAR), 2 * (radius + BAR));

  context.strokeStyle = palette.bad;
  context.lineWidth = 1.25;
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.stroke();
  // A light border separates the red line from the robot's body, whose colour is similar.
  for (const [colour, width] of [
    [palette.surface, 4],
    [palette.bad, 2],
  ] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.moveTo(x, y);
    context.lineTo(endX, endY);
    context.moveTo(endX - dy * BAR, endY + dx * BAR);
    context.lineTo(endX + dy * BAR, endY - dx * BAR);
    context.stroke();
  }
  if (contact.isCorner) {
    context.beginPath();
    context.arc(endX, endY, DOT, 0, 2 * Math.PI);
    context.fillStyle = palette.bad;
    context.fill();
    context.strokeStyle = palette.surface;
    context.lineWidth = 1.5;
    context.stroke();
  }
  return { origin: { x, y }, dx, dy };
}

/**
 * Places the label of the measure beyond the contact point, on the block or outside of the maze.
 * @returns its box, which no reading may cover; null if the view has no room for it
 */
export function placeRadiusLabel(viewport: Viewport, measure: Beam): Box | null {
  const { width, height } = LABEL;
  const robot = robotBox(viewport, measure.origin);
  const length = ROBOT_RADIUS * viewport.scale;
  const centres = readingCentres(measure, length, robot.width / 2, width, height);
  const request = { name: "radius", sizes: [{ width, height, centres }] };
  return placeLabels([request], [robot], viewport.view)[0] ?? null;
}

/** @param box its place */
export function drawRadiusLabel(
  context: DrawingContext,
  palette: Palette,
  { x, y, width, height }: Box,
  dirty: DirtyRects,
): void {
  dirty.add(x, y, width, height);
  context.beginPath();
  context.roundRect(x + 0.5, y + 0.5, width - 1, height - 1, 4);
  context.fillStyle = palette.surface;
  context.fill();
  context.strokeStyle = palette.bad;
  context.lineWidth = 1;
  context.stroke();
  context.font = `600 ${LABEL.font}px ${palette.font}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = palette.ink;
  context.fillText(String(ROBOT_RADIUS), x + width / 2, y + height / 2 + 0.5);
}
