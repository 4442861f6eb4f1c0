/**
 * Where the robot has been: the corners that it turned at, and its newest position.
 * Keeps a bounded number of corners, the newest; a robot may run for days.
 */

/** Corners kept. A corner costs two numbers, and one line when everything is drawn anew. */
const MAX_CORNERS = 20_000;
/** How many of the oldest go at once when there are too many: each loss means drawing all anew. */
const DROP = 5_000;

/** A line from point to point: x and y by turns, in units. */
export type Points = readonly number[];

/** What changed, and so what has to be drawn. */
export type TrailChange =
  | { kind: "none" }
  /** draw these points: what was added, and a little of what was there before */
  | { kind: "grown"; points: Points }
  /** draw everything anew */
  | { kind: "replaced" };

/** Units that a new piece goes back over the old one, so that no seam shows and no dot is lost. */
const OVERLAP = 15;

export class Trail {
  #corners: number[] = [];
  /** the newest piece, drawn again with the next one */
  #tail: number[] = [];
  #end: { x: number; y: number } | null = null;

  /**
   * Takes what a frame brings.
   * @param corners x and y by turns, in units; packed or not
   * @param end where the robot is now
   * @param isReset whether all before is to be forgotten
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
    this.#tail = lastPiece(points);
    return { kind: "grown", points };
  }

  /** The whole line, from the oldest corner kept to where the robot is; empty before the first frame. */
  points(): Points {
    return this.#end === null ? [] : [...this.#corners, this.#end.x, this.#end.y];
  }
}

/** The last points of a line, at least the overlap long if the line is. */
function lastPiece(points: Points): number[] {
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
