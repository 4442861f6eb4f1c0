/**
 * Where a trail has its corners: a straight line costs one point however long it is. What is not yet a
 * corner ends at the robot itself.
 */

/** A pen as plain data. */
export interface PenState {
  x: number;
  y: number;
  directionX: number;
  directionY: number;
}

export class TrailPen {
  #x: number;
  #y: number;
  #directionX = 0;
  #directionY = 0;
  /** the last corner that `follow` found */
  cornerX = Number.NaN;
  cornerY = Number.NaN;

  constructor(x: number, y: number) {
    this.#x = x;
    this.#y = y;
  }

  /**
   * Follows the robot to where it is at the end of a tick.
   * @returns whether it turned off where it was before: there the trail has a corner, `cornerX`, `cornerY`
   */
  moveTo(x: number, y: number): boolean {
    const directionX = x - this.#x;
    const directionY = y - this.#y;
    if (directionX === 0 && directionY === 0) return false;
    const cross = directionX * this.#directionY - directionY * this.#directionX;
    const dot = directionX * this.#directionX + directionY * this.#directionY;
    // Compared with the way at the last corner, so that a gentle curve gets its corners too. A way
    // that differs by less than a thousandth is straight: rounding, not driving.
    const isCorner = dot <= 0 || cross * cross > 1e-6 * dot * dot;
    if (isCorner) {
      this.cornerX = this.#x;
      this.cornerY = this.#y;
      this.#directionX = directionX;
      this.#directionY = directionY;
    }
    this.#x = x;
    this.#y = y;
    return isCorner;
  }

  save(): PenState {
    return { x: this.#x, y: this.#y, directionX: this.#directionX, directionY: this.#directionY };
  }

  restore(state: PenState): void {
    this.#x = state.x;
    this.#y = state.y;
    this.#directionX = state.directionX;
    this.#directionY = state.directionY;
  }
}
