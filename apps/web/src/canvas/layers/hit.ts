/** A bump while the robot stands at it: the block that was hit, in red, and where the robot wanted to go. */
import type { MazeDocument } from "@corridor/maze";
import type { Pose, SensorName, Snapshot } from "@corridor/protocol";
import type { Contact } from "@corridor/simulation";
import type { Brush } from "../brush.ts";
import type { Dirt } from "../dirt.ts";
import type { Palette } from "../palette.ts";
import { pointAhead } from "../path-ahead.ts";
import { TOUCHED_WITHIN } from "../touching.ts";
import { CELL, viewX, viewY, type Box, type Viewport } from "../viewport.ts";
import { touchOf } from "./bumps.ts";
import { drawOutline } from "./path.ts";
import { cellBox } from "./places.ts";
import { ROBOT_RADIUS } from "./robot.ts";

/** A bump at which the robot still stands. */
export interface Hit {
  /** where its centre was and how it faced */
  pose: Pose;
  /** units that it still wanted to drive; null when it would have gone on for ever */
  wanted: number | null;
}

/** Pixels of the maze's frame that are marked where the frame was hit. */
const FRAME = 5;
/** A robot that has moved this little has not left its bump (units). */
const STILL = 0.5;
/** Rays that go out at a bump: degrees from the way of the contact, and where they begin and end in pixels. */
const rays = [-50, -25, 25, 50];

/** Whether the robot is still where it bumped; turning on the spot does not lead away. */
export function isAtHit(hit: Hit | null, pose: Pose): hit is Hit {
  if (hit === null) return false;
  const dx = hit.pose.x - pose.x;
  const dy = hit.pose.y - pose.y;
  return dx * dx + dy * dy < STILL * STILL;
}

/** Degrees of the way from the robot's centre to the point that it touched. */
function headingTo({ x, y }: Pose, contact: Contact): number {
  return (Math.atan2(contact.x - x, y - contact.y) * 180) / Math.PI;
}

/**
 * The sensor that measures the block that was hit, as the robot faces now; null while none does. A beam
 * is thin and the robot is 50 cm wide: the beam may pass the corner that was hit.
 */
export function hitSensor(
  maze: MazeDocument,
  hit: Hit,
  { pose, sensors }: Pick<Snapshot, "pose" | "sensors">,
): SensorName | null {
  const contact = touchOf(maze, hit.pose);
  if (contact === null) return null;
  const turned = (((headingTo(hit.pose, contact) - pose.heading) % 360) + 360) % 360;
  const quarter = Math.round(turned / 90) % 4;
  const sensor = (["front", "right", "back", "left"] as const)[quarter] ?? null;
  return sensor !== null && sensors[sensor] <= TOUCHED_WITHIN ? sensor : null;
}

/** Unit vector away from the wall, for the recoil. */
export function awayFrom(maze: MazeDocument, hit: Hit): { dx: number; dy: number } {
  const contact = touchOf(maze, hit.pose);
  const towards = contact === null ? hit.pose.heading : headingTo(hit.pose, contact);
  const { x, y } = pointAhead({ x: 0, y: 0 }, towards, -1);
  return { dx: x, dy: y };
}

/** Draws the hit block, the rays of the impact, and the outline of where the robot wanted to go. */
export function drawHit(
  brush: Brush,
  viewport: Viewport,
  palette: Palette,
  maze: MazeDocument,
  hit: Hit,
  dirt: Dirt,
): void {
  const contact = touchOf(maze, hit.pose);
  if (contact === null) return;
  const towards = headingTo(hit.pose, contact);
  const box = hitBox(viewport, contact);
  dirt.add(box.x, box.y, box.width, box.height);
  brush.fillStyle = palette.badBg;
  brush.fillRect(box.x, box.y, box.width, box.height);
  brush.strokeStyle = palette.bad;
  brush.lineWidth = 1.5;
  brush.strokeRect(box.x + 0.75, box.y + 0.75, box.width - 1.5, box.height - 1.5);

  const distance = Math.min(hit.wanted ?? ROBOT_RADIUS, 2 * ROBOT_RADIUS);
  const wanted = pointAhead(hit.pose, drivenHeading(hit.pose, towards), distance);
  drawOutline(brush, viewport, palette.bad, { ...wanted, heading: hit.pose.heading }, dirt);

  const x = viewX(viewport, hit.pose.x);
  const y = viewY(viewport, hit.pose.y);
  const inner = (ROBOT_RADIUS + 5) * viewport.scale;
  const outer = (ROBOT_RADIUS + 18) * viewport.scale;
  dirt.add(x - outer, y - outer, 2 * outer, 2 * outer);
  brush.lineWidth = 2;
  brush.lineCap = "round";
  brush.beginPath();
  for (const ray of rays) {
    const from = pointAhead({ x, y }, towards + ray, inner);
    const to = pointAhead({ x, y }, towards + ray, outer);
    brush.moveTo(from.x, from.y);
    brush.lineTo(to.x, to.y);
  }
  brush.stroke();
}

/** The block that was hit, or the piece of the maze's frame. */
function hitBox(viewport: Viewport, { cell }: Contact): Box {
  const box = cellBox(viewport, cell);
  const { columns, rows, scale } = viewport;
  const from = { x: viewX(viewport, 0) - FRAME, y: viewY(viewport, 0) - FRAME };
  const to = {
    x: from.x + columns * CELL * scale + 2 * FRAME,
    y: from.y + rows * CELL * scale + 2 * FRAME,
  };
  const x = Math.max(box.x, from.x);
  const y = Math.max(box.y, from.y);
  return {
    x,
    y,
    width: Math.min(box.x + box.width, to.x) - x,
    height: Math.min(box.y + box.height, to.y) - y,
  };
}

/** The way that the robot drove when it met what lies in this direction: ahead or back. */
function drivenHeading({ heading }: Pose, towards: number): number {
  const apart = Math.abs(((((towards - heading) % 360) + 540) % 360) - 180);
  return apart <= 90 ? heading : heading + 180;
}
