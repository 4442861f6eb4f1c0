/** Where the robot has bumped: a small red burst at the place of contact. */
import { isBlock, type Cell, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import type { Pen } from "../brush.ts";
import type { Palette } from "../palette.ts";
import { CELL, viewX, viewY, type Viewport } from "../viewport.ts";
import { ROBOT_RADIUS } from "./robot.ts";

/** A place in units. */
export interface BumpMark {
  x: number;
  y: number;
}

/** A place on a wall, and the cell of the block; cells around the maze are walls too. */
interface Contact extends BumpMark, Cell {}

/** A touching disc ends this far before the wall at the most, in units. */
const TOUCH = 2;

/**
 * Where a robot that has just bumped touches a wall: the nearest point of a block around it. Between
 * two that it touches, the one ahead or behind rather than beside. Null where it touches none.
 */
export function contactOf(maze: MazeDocument, pose: Pose): Contact | null {
  const radians = (pose.heading * Math.PI) / 180;
  const headingX = Math.sin(radians);
  const headingY = -Math.cos(radians);
  const column = Math.floor(pose.x / CELL);
  const row = Math.floor(pose.y / CELL);
  let best: Contact | null = null;
  let mostAlong = Number.NEGATIVE_INFINITY;
  for (let c = column - 1; c <= column + 1; c++) {
    for (let r = row - 1; r <= row + 1; r++) {
      if (!isBlock(maze, c, r)) continue;
      const x = Math.min(Math.max(pose.x, c * CELL), (c + 1) * CELL);
      const y = Math.min(Math.max(pose.y, r * CELL), (r + 1) * CELL);
      const dx = x - pose.x;
      const dy = y - pose.y;
      const along = Math.abs(dx * headingX + dy * headingY);
      if (dx * dx + dy * dy > (ROBOT_RADIUS + TOUCH) ** 2 || along <= mostAlong) continue;
      best = { x, y, column: c, row: r };
      mostAlong = along;
    }
  }
  return best;
}

/** Where a bump is marked; the robot's centre where the wall has gone since. */
export function bumpMark(maze: MazeDocument, pose: Pose): BumpMark {
  return contactOf(maze, pose) ?? { x: pose.x, y: pose.y };
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
