/** The drawn trail: a polyline that discards its oldest corners when a robot runs for days. */
import { MAX_CORNERS } from "./frame.ts";

/**
 * Number of oldest corners that are discarded at once, because each discard redraws the whole
 * trail.
 */
const DROP = 5_000;

/** A polyline: x and y alternating, in units. */
export type Points = readonly number[];

/** How the trail changed, and so what has to be drawn. */
export type TrailChange =
  | { kind: "none" }
  /** draw these points: the new piece with an overlap */
  | { kind: "grown"; points: Points }
  /** redraw everything */
  | { kind: "replaced" };

/** Units by which a new piece overlaps the old one, so that no seam shows and no dot is covered. */
const OVERLAP = 15;

export class Trail {
  #corners: number[] = [];
  /** the newest piece, drawn again with the next one */
  #tail: number[] = [];
  #end: { x: number; y: number } | null = null;

  /**
   * Adds the positions of a frame.
   * @param corners x and y alternating, in units
   * @param end position of the robot now
   * @param isReset whether to discard the existing trail
   */
  add(
    corners: Points | Float64Array,
    end: { x: number; y: number },
    isReset: boolean,
  ): TrailChange {
    const before = this.#end;
    if (isReset) this.#corners = [];
    for (const value of corners) this.#corners.push(value);
    if (this.#corners.length === 0) this.#corners.push(end.x, end.y);
    this.#end = { x: end.x, y: end.y };
    const isFull = this.#corners.length > 2 * MAX_CORNERS;
    if (isFull) this.#corners.splice(0, 2 * DROP);
    if (isReset || isFull || before === null) {
      this.#tail = [end.x, end.y];
      return { kind: "replaced" };
    }
    if (corners.length === 0 && before.x === end.x && before.y === end.y) return { kind: "none" };
    const points = [...this.#tail, ...corners, end.x, end.y];
    this.#tail = tailOf(points);
    return { kind: "grown", points };
  }

  /** The whole polyline, from the oldest corner to the robot; empty before the first frame. */
  points(): Points {
    return this.#end === null ? [] : [...this.#corners, this.#end.x, this.#end.y];
  }
}

/** The last points of a polyline, at least `OVERLAP` units long if the polyline is. */
function tailOf(points: Points): number[] {
  let length = 0;
  let at = points.length - 2;
  while (at >= 2 && length < OVERLAP) {
    const dx = (points[at] ?? 0) - (points[at - 2] ?? 0);
    const dy = (points[at + 1] ?? 0) - (points[at - 1] ?? 0);
    length += Math.sqrt(dx * dx + dy * dy);
    at -= 2;
  }
  return points.slice(at);
}
