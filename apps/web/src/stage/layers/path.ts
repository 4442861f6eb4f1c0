/**
 * The path ahead: the dashed arrow of a delayed turn, and the outline of the pose at which a
 * command ends.
 */
import type { Pose } from "@corridor/protocol";
import type { Progress } from "@corridor/simulation";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import { delayedPath } from "./path-ahead.ts";
import { viewX, viewY, type Viewport } from "../drawing/viewport.ts";
import { ROBOT_HALF } from "../../ui/robot-outline.ts";
import { traceBody } from "./robot.ts";

/** Radius in units of the bend at the turning point. */
const BEND = 14;
const HEAD_PX = 9;

/**
 * Draws the path of a delayed turn; nothing while none runs. It starts under the robot, which is
 * drawn later.
 */
export function drawPath(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  pose: Pose,
  progress: Progress | null,
  dirty: DirtyRects,
): void {
  const points = delayedPath(pose, progress)?.map(({ x, y }) => ({
    x: viewX(viewport, x),
    y: viewY(viewport, y),
  }));
  const from = points?.[0];
  const end = points?.at(-1);
  const before = points?.at(-2);
  if (points === undefined || from === undefined || end === undefined || before === undefined) {
    return;
  }
  points.slice(1).forEach(({ x, y }, at) => {
    const start = points[at] ?? from;
    dirty.addLine(start.x, start.y, x, y, HEAD_PX + 2);
  });
  context.strokeStyle = palette.liveInk;
  context.lineWidth = 2;
  context.lineCap = "round";
  context.lineJoin = "round";
  context.setLineDash([4, 4]);
  context.beginPath();
  context.moveTo(from.x, from.y);
  if (points.length === 3) {
    const room = Math.sqrt((before.x - from.x) ** 2 + (before.y - from.y) ** 2);
    context.arcTo(before.x, before.y, end.x, end.y, Math.min(BEND * viewport.scale, room));
  }
  context.lineTo(end.x, end.y);
  context.stroke();
  context.setLineDash([]);

  const angle = Math.atan2(end.y - before.y, end.x - before.x);
  context.save();
  context.translate(end.x, end.y);
  context.rotate(angle);
  context.beginPath();
  context.moveTo(-HEAD_PX, -HEAD_PX * 0.75);
  context.lineTo(0, 0);
  context.lineTo(-HEAD_PX, HEAD_PX * 0.75);
  context.stroke();
  context.restore();
}

/** Draws the dashed outline of the robot at a pose, with a mark for the heading. */
export function drawOutline(
  context: DrawingContext,
  viewport: Viewport,
  colour: string,
  pose: Pose,
  dirty: DirtyRects,
): void {
  const x = viewX(viewport, pose.x);
  const y = viewY(viewport, pose.y);
  const reach = ROBOT_HALF * viewport.scale;
  dirty.add(x - reach, y - reach, 2 * reach, 2 * reach);
  context.save();
  context.translate(x, y);
  context.rotate((pose.heading * Math.PI) / 180);
  context.scale(viewport.scale, viewport.scale);
  context.strokeStyle = colour;
  context.lineWidth = 1.75 / viewport.scale;
  context.setLineDash([4 / viewport.scale, 3 / viewport.scale]);
  traceBody(context);
  context.setLineDash([]);
  context.beginPath();
  context.moveTo(-5, -13);
  context.lineTo(0, -18);
  context.lineTo(5, -13);
  context.stroke();
  context.restore();
}
