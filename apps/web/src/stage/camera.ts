/**
 * Camera that follows the robot where the stage shows only a part of the maze. It centres the
 * robot. If the user prefers reduced motion, it stands still and jumps when the robot comes near
 * its edge.
 *
 * Its position depends on layout and pose alone. Painter and page see different poses of a drive
 * and still agree on it.
 */
import type { Pose } from "@corridor/protocol";
import { centredScroll, steppedScroll, type Layout, type Scroll } from "./drawing/viewport.ts";

export class Camera {
  #scroll: Scroll = { x: 0, y: 0 };

  /**
   * Scroll position of the camera for a robot.
   * @param step size of one device pixel in CSS pixels
   */
  at(layout: Layout, pose: Pose, isCalm: boolean, step: number): Scroll {
    const next = (isCalm ? steppedScroll : centredScroll)(layout, pose.x, pose.y);
    const { x, y } = { x: snapTo(next.x, step), y: snapTo(next.y, step) };
    if (x !== this.#scroll.x || y !== this.#scroll.y) this.#scroll = { x, y };
    return this.#scroll;
  }
}

/** Hairlines stay sharp on whole device pixels. */
function snapTo(position: number, step: number): number {
  return Math.round(position / step) * step;
}
