/** Rays around the robot while it stands on a goal that it has reached. */
import { CELL, type MazeDocument } from "@corridor/maze";
import type { Pose, Snapshot } from "@corridor/protocol";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import { pointAhead } from "./path-ahead.ts";
import { viewX, viewY, type Viewport } from "../drawing/viewport.ts";

const RAYS = 12;
/** Units from the robot's centre to the start of a ray, and to the end of long and short rays. */
const INNER = 38;
const OUTER = [49, 46] as const;
const WIDTH = 2.6;

/** Whether the robot stands on a goal and has reached it. */
export function isOnReachedGoal(
  maze: Pick<MazeDocument, "goals">,
  { goalReached, pose }: Pick<Snapshot, "goalReached" | "pose">,
): boolean {
  if (!goalReached) return false;
  const column = Math.floor(pose.x / CELL);
  const row = Math.floor(pose.y / CELL);
  return maze.goals.some((goal) => goal.column === column && goal.row === row);
}

export function drawCelebration(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  pose: Pose,
  dirty: DirtyRects,
): void {
  const centre = { x: viewX(viewport, pose.x), y: viewY(viewport, pose.y) };
  const reach = (OUTER[0] + WIDTH) * viewport.scale;
  dirty.add(centre.x - reach, centre.y - reach, 2 * reach, 2 * reach);
  context.strokeStyle = palette.live;
  context.lineWidth = Math.max(1, WIDTH * viewport.scale);
  context.lineCap = "round";
  context.beginPath();
  for (let ray = 0; ray < RAYS; ray++) {
    const towards = ((ray + 0.5) * 360) / RAYS;
    const from = pointAhead(centre, towards, INNER * viewport.scale);
    const to = pointAhead(centre, towards, (OUTER[ray % 2] ?? INNER) * viewport.scale);
    context.moveTo(from.x, from.y);
    context.lineTo(to.x, to.y);
  }
  context.stroke();
}
