/**
 * The camera that goes with the robot where only a part of the maze shows. It has the robot in its middle;
 * for readers who asked for less motion it stands still and cuts when the robot comes near its edge.
 * Its place follows from layout and pose alone: the painter and the page, which see different poses of a
 * drive, agree on it.
 */
import type { Pose } from "@corridor/protocol";
import { centredScroll, steppedScroll, type Layout, type Scroll } from "./viewport.ts";

export class Camera {
  #scroll: Scroll = { x: 0, y: 0 };

  /** Where it stands for a robot. @param step the smallest move in CSS pixels: one of the device's own */
  at(layout: Layout, pose: Pose, isCalm: boolean, step: number): Scroll {
    const next = (isCalm ? steppedScroll : centredScroll)(layout, pose.x, pose.y);
    const { x, y } = { x: whole(next.x, step), y: whole(next.y, step) };
    if (x !== this.#scroll.x || y !== this.#scroll.y) this.#scroll = { x, y };
    return this.#scroll;
  }
}

/** Hairlines stay sharp on whole pixels of the device. */
function whole(position: number, step: number): number {
  return Math.round(position / step) * step;
}
