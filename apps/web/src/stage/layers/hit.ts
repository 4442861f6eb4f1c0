/**
 * A bump while the robot stands at it: the block that was hit, in red, and the position that the
 * robot was driving to.
 */
import { CELL, type MazeDocument } from "@corridor/maze";
import { sensorNames, type Pose, type SensorName, type Snapshot } from "@corridor/protocol";
import { ROBOT_RADIUS, type Contact } from "@corridor/simulation";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import { pointAhead } from "./path-ahead.ts";
import { CONTACT_RANGE } from "../drawing/contact-sensor.ts";
import { viewX, viewY, type Box, type Viewport } from "../drawing/viewport.ts";
import { touchOf } from "./bumps.ts";
import { drawOutline } from "./path.ts";
import { cellBox } from "./places.ts";

/** A bump that the robot has not left yet. */
export interface Hit {
  /** pose of the robot at the bump */
  pose: Pose;
  /** units that the drive still had left; null for an unlimited drive */
  wanted: number | null;
}

/** Width in pixels of the mark on the maze's frame where the robot hit the frame. */
const FRAME = 5;
/** A robot that has moved less than this many units has not left its bump. */
const STILL = 0.5;
/** Rays of the impact: degrees from the direction of the contact. */
const rays = [-50, -25, 25, 50];

/** Whether the robot is still where it bumped. Turning on the spot does not count as leaving. */
export function isAtHit(hit: Hit | null, pose: Pose): hit is Hit {
  if (hit === null) return false;
  const dx = hit.pose.x - pose.x;
  const dy = hit.pose.y - pose.y;
  return dx * dx + dy * dy < STILL * STILL;
}

/** Heading in degrees from the robot's centre to the contact point. */
function headingTo({ x, y }: Pose, contact: Contact): number {
  return (Math.atan2(contact.x - x, y - contact.y) * 180) / Math.PI;
}

/**
 * The sensor that measures the block that was hit, at the robot's current heading; null while none
 * does. A beam is thin and the robot is 50 units wide, so a beam may miss the corner that was hit.
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
  const sensor = sensorNames[quarter] ?? null;
  return sensor !== null && sensors[sensor] <= CONTACT_RANGE ? sensor : null;
}

/** Unit vector away from the wall, for the recoil. */
export function recoilDirection(maze: MazeDocument, hit: Hit): { dx: number; dy: number } {
  const contact = touchOf(maze, hit.pose);
  const towards = contact === null ? hit.pose.heading : headingTo(hit.pose, contact);
  const { x, y } = pointAhead({ x: 0, y: 0 }, towards, -1);
  return { dx: x, dy: y };
}

/**
 * Draws the block that was hit, the rays of the impact, and the outline of the position that the
 * robot was driving to.
 */
export function drawHit(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  maze: MazeDocument,
  hit: Hit,
  dirty: DirtyRects,
): void {
  const contact = touchOf(maze, hit.pose);
  if (contact === null) return;
  const towards = headingTo(hit.pose, contact);
  const box = hitBox(viewport, contact);
  // The frame of a run that opens can arrive before its maze, which may be larger than the one here.
  if (box.width <= 0 || box.height <= 0) return;
  dirty.add(box.x, box.y, box.width, box.height);
  context.fillStyle = palette.badBg;
  context.fillRect(box.x, box.y, box.width, box.height);
  context.strokeStyle = palette.bad;
  context.lineWidth = 1.5;
  context.strokeRect(box.x + 0.75, box.y + 0.75, box.width - 1.5, box.height - 1.5);

  const distance = Math.min(hit.wanted ?? ROBOT_RADIUS, 2 * ROBOT_RADIUS);
  const wanted = pointAhead(hit.pose, drivenHeading(hit.pose, towards), distance);
  drawOutline(context, viewport, palette.bad, { ...wanted, heading: hit.pose.heading }, dirty);

  const x = viewX(viewport, hit.pose.x);
  const y = viewY(viewport, hit.pose.y);
  const inner = (ROBOT_RADIUS + 5) * viewport.scale;
  const outer = (ROBOT_RADIUS + 18) * viewport.scale;
  dirty.add(x - outer, y - outer, 2 * outer, 2 * outer);
  context.lineWidth = 2;
  context.lineCap = "round";
  context.beginPath();
  for (const ray of rays) {
    const from = pointAhead({ x, y }, towards + ray, inner);
    const to = pointAhead({ x, y }, towards + ray, outer);
    context.moveTo(from.x, from.y);
    context.lineTo(to.x, to.y);
  }
  context.stroke();
}

/** The block that was hit, or the part of the maze's frame. */
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

/** Heading of the drive that met the contact: forwards or backwards. */
function drivenHeading({ heading }: Pose, towards: number): number {
  const apart = Math.abs(((((towards - heading) % 360) + 540) % 360) - 180);
  return apart <= 90 ? heading : heading + 180;
}
