/**
 * The position of the invisible grid over the drawn maze, and the part that receives the pointer.
 * Pure.
 */
import type { Pose } from "@corridor/protocol";
import type { Camera } from "../camera.ts";
import type { Layout } from "../drawing/viewport.ts";

/**
 * Pixels by which the grid is moved from its position in the content. The browser moves it when the
 * user scrolls, but not when the camera moves.
 * @param pixelRatio device pixels per CSS pixel
 */
export function gridOffset(
  camera: Camera,
  layout: Layout,
  pose: Pose | null,
  isCalm: boolean,
  pixelRatio: number,
): { x: number; y: number } {
  if (!layout.follows || pose === null) return { x: 0, y: 0 };
  const { x, y } = camera.at(layout, pose, isCalm, 1 / pixelRatio);
  return { x: -x, y: -y };
}

/** Whether a pixel of the view is inside the part that displays the maze. */
export function isInPort({ port }: Layout, x: number, y: number): boolean {
  return x >= port.x && y >= port.y && x < port.x + port.width && y < port.y + port.height;
}
