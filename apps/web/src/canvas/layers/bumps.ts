/** Where the robot has bumped: a small red burst at the place of contact. */
import type { MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import { contactOf, type Contact } from "@corridor/simulation";
import type { Pen } from "../brush.ts";
import type { Palette } from "../palette.ts";
import { viewX, viewY, type Viewport } from "../viewport.ts";
import { ROBOT_RADIUS } from "./robot.ts";

/** A place in units. */
export interface BumpMark {
  x: number;
  y: number;
}

/** A touching disc ends this far before the wall at the most, in units. */
const TOUCH = 2;

/** Where a robot that has just bumped touches a block, ahead or behind; null where it touches none. */
export function touchOf(maze: MazeDocument, pose: Pose): Contact | null {
  const touches = (["front", "back"] as const)
    .map((side) => contactOf(maze, pose, side))
    .map((contact) => ({ contact, distance: Math.hypot(contact.x - pose.x, contact.y - pose.y) }))
    .filter(({ distance }) => distance > 0 && distance <= ROBOT_RADIUS + TOUCH);
  const [front, back] = touches;
  const isBack = back !== undefined && front !== undefined && back.distance < front.distance;
  return (isBack ? back : front)?.contact ?? null;
}

/** Where a bump is marked; the robot's centre where the wall has gone since. */
export function bumpMark(maze: MazeDocument, pose: Pose): BumpMark {
  return touchOf(maze, pose) ?? { x: pose.x, y: pose.y };
}

/**
 * The marks of bumps.
 * @param places where the robot's centre was, x and y by turns, in units
 * @param heading of the robot now; the newest bumps happened with it
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

/** Draws the bursts. */
export function drawBumps(
  context: Pen,
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
