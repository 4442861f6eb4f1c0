/** Where the robot is going: the dashed arrow of a delayed turn, and the outline of where a command ends. */
import type { Pose } from "@corridor/protocol";
import type { Progress } from "@corridor/simulation";
import type { Brush } from "../brush.ts";
import type { Dirt } from "../dirt.ts";
import type { Palette } from "../palette.ts";
import { delayedPath } from "../path-ahead.ts";
import { viewX, viewY, type Viewport } from "../viewport.ts";
import { traceBody } from "./robot.ts";

/** Units of the corner's bend at the turning point. */
const BEND = 14;
const HEAD_PX = 9;

/** Draws the way of a delayed turn; nothing while none runs. It begins under the robot, which is drawn later. */
export function drawPath(
  brush: Brush,
  viewport: Viewport,
  palette: Palette,
  pose: Pose,
  progress: Progress | null,
  dirt: Dirt,
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
    dirt.addLine(start.x, start.y, x, y, HEAD_PX + 2);
  });
  brush.strokeStyle = palette.liveInk;
  brush.lineWidth = 2;
  brush.lineCap = "round";
  brush.lineJoin = "round";
  brush.setLineDash([4, 4]);
  brush.beginPath();
  brush.moveTo(from.x, from.y);
  if (points.length === 3) {
    const room = Math.sqrt((before.x - from.x) ** 2 + (before.y - from.y) ** 2);
    brush.arcTo(before.x, before.y, end.x, end.y, Math.min(BEND * viewport.scale, room));
  }
  brush.lineTo(end.x, end.y);
  brush.stroke();
  brush.setLineDash([]);

  const angle = Math.atan2(end.y - before.y, end.x - before.x);
  brush.save();
  brush.translate(end.x, end.y);
  brush.rotate(angle);
  brush.beginPath();
  brush.moveTo(-HEAD_PX, -HEAD_PX * 0.75);
  brush.lineTo(0, 0);
  brush.lineTo(-HEAD_PX, HEAD_PX * 0.75);
  brush.stroke();
  brush.restore();
}

/** Draws where the robot would stand: its outline, dashed, with a mark where it would look. */
export function drawOutline(
  brush: Brush,
  viewport: Viewport,
  colour: string,
  pose: Pose,
  dirt: Dirt,
): void {
  const x = viewX(viewport, pose.x);
  const y = viewY(viewport, pose.y);
  const reach = 28 * viewport.scale;
  dirt.add(x - reach, y - reach, 2 * reach, 2 * reach);
  brush.save();
  brush.translate(x, y);
  brush.rotate((pose.heading * Math.PI) / 180);
  brush.scale(viewport.scale, viewport.scale);
  brush.strokeStyle = colour;
  brush.lineWidth = 1.75 / viewport.scale;
  brush.setLineDash([4 / viewport.scale, 3 / viewport.scale]);
  traceBody(brush);
  brush.setLineDash([]);
  brush.beginPath();
  brush.moveTo(-5, -13);
  brush.lineTo(0, -18);
  brush.lineTo(5, -13);
  brush.stroke();
  brush.restore();
}
