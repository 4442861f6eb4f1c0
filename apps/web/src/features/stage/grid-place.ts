/** Where the invisible grid lies over the drawn maze, and which part of it takes the pointer. Pure. */
import type { Pose } from "@corridor/protocol";
import type { Camera } from "../../canvas/camera.ts";
import type { Layout } from "../../canvas/viewport.ts";

/**
 * Pixels by which the grid is moved from its place in the content. Scrolling moves it by itself; a camera,
 * which only the painter knows of, does not.
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

/** Whether a pixel of the view belongs to the part in which the maze may show. */
export function isInPort({ port }: Layout, x: number, y: number): boolean {
  return x >= port.x && y >= port.y && x < port.x + port.width && y < port.y + port.height;
}
