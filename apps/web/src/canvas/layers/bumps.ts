/** Where the robot has bumped: a small red burst at the place of contact. */
import { isBlock, type MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import type { Palette } from "../palette.ts";
import { CELL, viewX, viewY, type Viewport } from "../viewport.ts";
import { ROBOT_RADIUS } from "./robot.ts";

/** A place in units. */
export interface BumpMark {
  x: number;
  y: number;
}

/** A touching disc ends this far before the wall at the most, in units. */
const TOUCH = 2;

/** Where a robot that has just bumped touches a wall: ahead, behind or, where neither, at its centre. */
export function bumpMark(maze: MazeDocument, pose: Pose): BumpMark {
  const radians = (pose.heading * Math.PI) / 180;
  const dx = Math.sin(radians);
  const dy = -Math.cos(radians);
  for (const side of [1, -1]) {
    const reach = side * (ROBOT_RADIUS + TOUCH);
    const column = Math.floor((pose.x + dx * reach) / CELL);
    const row = Math.floor((pose.y + dy * reach) / CELL);
    if (isBlock(maze, column, row)) {
      return { x: pose.x + dx * side * ROBOT_RADIUS, y: pose.y + dy * side * ROBOT_RADIUS };
    }
  }
  return { x: pose.x, y: pose.y };
}

const POINTS = 8;

/** Draws the bursts. */
export function drawBumps(
  context: CanvasRenderingContext2D,
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
