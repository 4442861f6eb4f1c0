/**
 * The robot's radius at a bump: a thin circle, and a measure from the centre to the point that was touched. It
 * shows why a robot bumps whose beam passes a corner: the beam is thin, the robot is 50 cm wide.
 */
import type { MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import type { Brush } from "../brush.ts";
import type { Dirt } from "../dirt.ts";
import type { Palette } from "../palette.ts";
import { placeTags, readingCentres, type Beam } from "../tag-placement.ts";
import { viewX, viewY, type Box, type Viewport } from "../viewport.ts";
import { touchOf } from "./bumps.ts";
import { robotBox, ROBOT_RADIUS } from "./robot.ts";

const LABEL = { width: 22, height: 16, font: 12 };
/** Half the length of the bar at the touched point, and the radius of a corner's dot, in pixels. */
const BAR = 5;
const DOT = 4;

/** @returns the measure; null where nothing is touched any more */
export function drawRadius(
  brush: Brush,
  viewport: Viewport,
  palette: Palette,
  maze: MazeDocument,
  pose: Pose,
  dirt: Dirt,
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
  dirt.add(x - radius - BAR, y - radius - BAR, 2 * (radius + BAR), 2 * (radius + BAR));

  brush.strokeStyle = palette.bad;
  brush.lineWidth = 1.25;
  brush.beginPath();
  brush.arc(x, y, radius, 0, 2 * Math.PI);
  brush.stroke();
  // Over the robot's body, whose colour is near to red.
  for (const [colour, width] of [
    [palette.surface, 4],
    [palette.bad, 2],
  ] as const) {
    brush.strokeStyle = colour;
    brush.lineWidth = width;
    brush.beginPath();
    brush.moveTo(x, y);
    brush.lineTo(endX, endY);
    brush.moveTo(endX - dy * BAR, endY + dx * BAR);
    brush.lineTo(endX + dy * BAR, endY - dx * BAR);
    brush.stroke();
  }
  if (contact.isCorner) {
    brush.beginPath();
    brush.arc(endX, endY, DOT, 0, 2 * Math.PI);
    brush.fillStyle = palette.bad;
    brush.fill();
    brush.strokeStyle = palette.surface;
    brush.lineWidth = 1.5;
    brush.stroke();
  }
  return { origin: { x, y }, dx, dy };
}

/**
 * The number of the measure: beyond the touched point, on the block or outside of the maze.
 * @returns its place, where no reading may stand; null where the view has no room for it
 */
export function drawRadiusLabel(
  brush: Brush,
  viewport: Viewport,
  palette: Palette,
  measure: Beam,
  dirt: Dirt,
): Box | null {
  const { width, height, font } = LABEL;
  const robot = robotBox(viewport, measure.origin);
  const length = ROBOT_RADIUS * viewport.scale;
  const centres = readingCentres(measure, length, robot.width / 2, width, height);
  const request = { name: "radius", sizes: [{ width, height, centres }] };
  const [box] = placeTags([request], [robot], viewport.view);
  if (box === undefined) return null;
  dirt.add(box.x, box.y, width, height);
  brush.beginPath();
  brush.roundRect(box.x + 0.5, box.y + 0.5, width - 1, height - 1, 4);
  brush.fillStyle = palette.surface;
  brush.fill();
  brush.strokeStyle = palette.bad;
  brush.lineWidth = 1;
  brush.stroke();
  brush.font = `600 ${font}px ${palette.font}`;
  brush.textAlign = "center";
  brush.textBaseline = "middle";
  brush.fillStyle = palette.ink;
  brush.fillText(String(ROBOT_RADIUS), box.x + width / 2, box.y + height / 2 + 0.5);
  return box;
}
