/** Marks of bumps: a small red burst at each contact point. */
import type { MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import { ROBOT_RADIUS, contactOf, type Contact } from "@corridor/simulation";
import type { VectorContext } from "../drawing/drawing-context.ts";
import type { Palette } from "../drawing/palette.ts";
import { viewX, viewY, type Viewport } from "../drawing/viewport.ts";

/** A position in units. */
export interface BumpMark {
  x: number;
  y: number;
}

/** Largest distance in units between the robot's edge and a wall that it touches. */
const TOUCH = 2;

/** The contact of a robot that has just bumped, ahead or behind; null where it touches nothing. */
export function touchOf(maze: MazeDocument, pose: Pose): Contact | null {
  const touches = (["front", "back"] as const)
    .map((side) => contactOf(maze, pose, side))
    .map((contact) => ({ contact, distance: Math.hypot(contact.x - pose.x, contact.y - pose.y) }))
    .filter(({ distance }) => distance > 0 && distance <= ROBOT_RADIUS + TOUCH);
  const [front, back] = touches;
  const isBack = back !== undefined && front !== undefined && back.distance < front.distance;
  return (isBack ? back : front)?.contact ?? null;
}

/** Position of a bump's mark; the robot's centre if the wall has been removed since. */
export function bumpMark(maze: MazeDocument, pose: Pose): BumpMark {
  return touchOf(maze, pose) ?? { x: pose.x, y: pose.y };
}

/**
 * Marks of several bumps.
 * @param places positions of the robot's centre, x and y alternating, in units
 * @param heading heading of the robot now, which is also that of the newest bumps
 */
export function bumpMarks(
  maze: MazeDocument,
  places: readonly number[],
  heading: number,
): BumpMark[] {
  const marks: BumpMark[] = [];
  for (let at = 0; at + 1 < places.length; at += 2) {
    marks.push(bumpMark(maze, { x: places[at] ?? 0, y: places[at + 1] ?? 0, heading }));
  }
  return marks;
}

const POINTS = 8;

/** Draws the marks. */
export function drawBumps(
  context: VectorContext,
  viewport: Viewport,
  palette: Palette,
  marks: readonly BumpMark[],
): void {
  const outer = Math.min(7, Math.max(4, 9 * viewport.scale));
  context.beginPath();
  for (const mark of marks) {
    const x = viewX(viewport, mark.x);
    const y = viewY(viewport, mark.y);
    for (let at = 0; at < 2 * POINTS; at++) {
      const radius = at % 2 === 0 ? outer : outer * 0.65;
      const angle = (at * Math.PI) / POINTS;
      const px = x + Math.sin(angle) * radius;
      const py = y - Math.cos(angle) * radius;
      if (at === 0) context.moveTo(px, py);
      else context.lineTo(px, py);
    }
    context.closePath();
  }
  context.fillStyle = palette.surface;
  context.fill();
  context.strokeStyle = palette.bad;
  context.lineWidth = 1.5;
  context.lineJoin = "round";
  context.stroke();
}
