/**
 * The ghosts of a race: the robot's outline without a face, filled like the floor, and a round badge
 * with a letter. Each letter has a corner of its own, so that ghosts in one place can be told apart.
 */
import type { GhostPose } from "../../worker/worker-messages.ts";
import type { Brush } from "../brush.ts";
import type { Dirt } from "../dirt.ts";
import type { Palette } from "../palette.ts";
import { viewX, viewY, type Viewport } from "../viewport.ts";
import { fillBody, ROBOT_RADIUS, traceBody } from "./robot.ts";

/** Pixels. */
export const BADGE_RADIUS = 9;
const OUTLINE = 2;
/** Units from the centre to the corner of the body, with its outline. */
const REACH = 28;
/** In the order of the letters A to D: to the right (1) or left (-1), down (1) or up (-1). */
const corners = [
  { x: 1, y: -1 },
  { x: -1, y: -1 },
  { x: 1, y: 1 },
  { x: -1, y: 1 },
] as const;
const DIAGONAL = Math.SQRT1_2;

/** Draws the ghosts below the robot, and their badges beside it. */
export function drawRaceGhosts(
  brush: Brush,
  viewport: Viewport,
  palette: Palette,
  ghosts: readonly GhostPose[],
  dirt: Dirt,
): void {
  for (const ghost of ghosts) drawBody(brush, viewport, palette, ghost, dirt);
  for (const ghost of ghosts) drawBadge(brush, viewport, palette, ghost, dirt);
}

function drawBody(
  brush: Brush,
  viewport: Viewport,
  palette: Palette,
  { x, y, heading }: GhostPose,
  dirt: Dirt,
): void {
  const { scale } = viewport;
  const atX = viewX(viewport, x);
  const atY = viewY(viewport, y);
  const reach = REACH * scale + OUTLINE;
  dirt.add(atX - reach, atY - reach, 2 * reach, 2 * reach);
  brush.save();
  brush.translate(atX, atY);
  brush.rotate((heading * Math.PI) / 180);
  brush.scale(scale, scale);
  brush.globalAlpha = 0.7;
  brush.fillStyle = palette.floor;
  fillBody(brush);
  brush.globalAlpha = 1;
  brush.strokeStyle = palette.ink2;
  brush.lineWidth = OUTLINE / scale;
  traceBody(brush);
  // Where it faces.
  brush.lineCap = "round";
  brush.beginPath();
  brush.moveTo(-9, -6);
  brush.lineTo(0, -15);
  brush.lineTo(9, -6);
  brush.stroke();
  brush.restore();
}

function drawBadge(
  brush: Brush,
  viewport: Viewport,
  palette: Palette,
  { badge, x, y }: GhostPose,
  dirt: Dirt,
): void {
  const beside = badgeOffset(badge, viewport.scale);
  const atX = viewX(viewport, x) + beside.x;
  const atY = viewY(viewport, y) + beside.y;
  const reach = BADGE_RADIUS + 1;
  dirt.add(atX - reach, atY - reach, 2 * reach, 2 * reach);
  brush.fillStyle = palette.ink;
  brush.strokeStyle = palette.floor;
  brush.lineWidth = 1.5;
  brush.beginPath();
  brush.arc(atX, atY, BADGE_RADIUS, 0, 2 * Math.PI);
  brush.fill();
  brush.stroke();
  brush.fillStyle = palette.onInk;
  brush.font = `650 12px ${palette.font}`;
  brush.textAlign = "center";
  brush.textBaseline = "middle";
  brush.fillText(badge, atX, atY + 0.5);
}

/** Where the badge of a letter stands from the ghost's centre, in pixels: it touches the body, and covers none of it. */
export function badgeOffset(badge: string, scale: number): { x: number; y: number } {
  const corner = corners[badge.charCodeAt(0) - "A".charCodeAt(0)] ?? corners[0];
  const away = (ROBOT_RADIUS * scale + BADGE_RADIUS) * DIAGONAL;
  return { x: corner.x * away, y: corner.y * away };
}
