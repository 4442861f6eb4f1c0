/** The robot on the goal that it has reached: rays all around it, as long as it stands there. */
import type { MazeDocument } from "@corridor/maze";
import type { Pose, Snapshot } from "@corridor/protocol";
import type { Brush } from "../brush.ts";
import type { Dirt } from "../dirt.ts";
import type { Palette } from "../palette.ts";
import { pointAhead } from "../path-ahead.ts";
import { CELL, viewX, viewY, type Viewport } from "../viewport.ts";

const RAYS = 12;
/** Units from the robot's centre: where rays begin, and where long and short ones end by turns. */
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

export function drawJoy(
  brush: Brush,
  viewport: Viewport,
  palette: Palette,
  pose: Pose,
  dirt: Dirt,
): void {
  const centre = { x: viewX(viewport, pose.x), y: viewY(viewport, pose.y) };
  const reach = (OUTER[0] + WIDTH) * viewport.scale;
  dirt.add(centre.x - reach, centre.y - reach, 2 * reach, 2 * reach);
  brush.strokeStyle = palette.live;
  brush.lineWidth = Math.max(1, WIDTH * viewport.scale);
  brush.lineCap = "round";
  brush.beginPath();
  for (let ray = 0; ray < RAYS; ray++) {
    const towards = ((ray + 0.5) * 360) / RAYS;
    const from = pointAhead(centre, towards, INNER * viewport.scale);
    const to = pointAhead(centre, towards, (OUTER[ray % 2] ?? INNER) * viewport.scale);
    brush.moveTo(from.x, from.y);
    brush.lineTo(to.x, to.y);
  }
  brush.stroke();
}
