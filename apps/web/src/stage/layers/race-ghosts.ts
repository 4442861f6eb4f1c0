/**
 * The ghosts of a race: the robot's outline without a face, filled like the floor, and a round
 * badge with a letter. Each letter has its own place beside the body, so that ghosts at one
 * position can be distinguished without colours.
 */
import { ROBOT_RADIUS } from "@corridor/simulation";
import { GHOST_BADGES, type GhostPose } from "../drawing/frame.ts";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import type { DirtyRects } from "../drawing/dirty-rects.ts";
import type { Palette } from "../drawing/palette.ts";
import { viewX, viewY, type Viewport } from "../drawing/viewport.ts";
import { ROBOT_HALF } from "../../ui/robot-outline.ts";
import { fillBody, traceBody } from "./robot.ts";

/** Pixels. */
export const BADGE_RADIUS = 9;
const OUTLINE = 2;
/** Pixels between the centres of two badges beside each other. */
const BADGE_PITCH = 2 * BADGE_RADIUS + 1;
const DIAGONAL = Math.SQRT1_2;
/** For the letters A to D, and again for E to G: right (1) or left (-1), down (1) or up (-1). */
const corners = [
  { x: 1, y: -1 },
  { x: -1, y: -1 },
  { x: 1, y: 1 },
  { x: -1, y: 1 },
] as const;

/** Draws the ghosts below the robot, and their badges beside it. */
export function drawRaceGhosts(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  ghosts: readonly GhostPose[],
  dirty: DirtyRects,
): void {
  for (const ghost of ghosts) drawBody(context, viewport, palette, ghost, dirty);
  for (const ghost of ghosts) drawLeader(context, viewport, palette, ghost);
  for (const ghost of ghosts) drawBadge(context, viewport, palette, ghost, dirty);
}

function drawBody(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  { x, y, heading }: GhostPose,
  dirty: DirtyRects,
): void {
  const { scale } = viewport;
  const atX = viewX(viewport, x);
  const atY = viewY(viewport, y);
  const reach = ROBOT_HALF * scale + OUTLINE;
  dirty.add(atX - reach, atY - reach, 2 * reach, 2 * reach);
  context.save();
  context.translate(atX, atY);
  context.rotate((heading * Math.PI) / 180);
  context.scale(scale, scale);
  context.globalAlpha = 0.7;
  context.fillStyle = palette.floor;
  fillBody(context);
  context.globalAlpha = 1;
  context.strokeStyle = palette.ink2;
  context.lineWidth = OUTLINE / scale;
  traceBody(context);
  // Arrow head that shows the heading.
  context.lineCap = "round";
  context.beginPath();
  context.moveTo(-9, -6);
  context.lineTo(0, -15);
  context.lineTo(9, -6);
  context.stroke();
  context.restore();
}

/** From the body to a badge that does not touch it. */
function drawLeader(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  { badge, x, y }: GhostPose,
): void {
  if (!isOuter(badge)) return;
  const beside = badgeOffset(badge, viewport.scale);
  const inside = (ROBOT_RADIUS * viewport.scale) / Math.hypot(beside.x, beside.y);
  const atX = viewX(viewport, x);
  const atY = viewY(viewport, y);
  context.strokeStyle = palette.ink;
  context.lineWidth = 1.5;
  context.beginPath();
  context.moveTo(atX + inside * beside.x, atY + inside * beside.y);
  context.lineTo(atX + beside.x, atY + beside.y);
  context.stroke();
}

function drawBadge(
  context: DrawingContext,
  viewport: Viewport,
  palette: Palette,
  { badge, x, y }: GhostPose,
  dirty: DirtyRects,
): void {
  const beside = badgeOffset(badge, viewport.scale);
  const atX = viewX(viewport, x) + beside.x;
  const atY = viewY(viewport, y) + beside.y;
  // The badge, and its line to the body.
  const reach = BADGE_RADIUS + 1 + (isOuter(badge) ? BADGE_PITCH : 0);
  dirty.add(atX - reach, atY - reach, 2 * reach, 2 * reach);
  context.fillStyle = palette.ink;
  context.strokeStyle = palette.floor;
  context.lineWidth = 1.5;
  context.beginPath();
  context.arc(atX, atY, BADGE_RADIUS, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
  context.fillStyle = palette.onInk;
  context.font = `650 12px ${palette.font}`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillText(badge, atX, atY + 0.5);
}

/**
 * Offset in pixels of a badge from the ghost's centre. A to D touch the body; E to G are behind A to
 * C. No badge covers the body, another badge or a sensor's reading, which are straight ahead.
 */
export function badgeOffset(badge: string, scale: number): { x: number; y: number } {
  const at = Math.max(0, GHOST_BADGES.indexOf(badge));
  const { x, y } = corners[at % corners.length] ?? corners[0];
  // A tiny robot has no room for four badges around it: they touch each other instead.
  const inner = Math.max(ROBOT_RADIUS * scale + BADGE_RADIUS, BADGE_PITCH * DIAGONAL);
  const away = (inner + (isOuter(badge) ? BADGE_PITCH : 0)) * DIAGONAL;
  return { x: x * away, y: y * away };
}

function isOuter(badge: string): boolean {
  return GHOST_BADGES.indexOf(badge) >= corners.length;
}
