/**
 * Finds the corners of a trail, so that a straight line of any length needs one point. The last
 * line ends at the robot.
 */

/** Serialisable state of a pen. */
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
  /** the last corner that `moveTo` found */
  cornerX = Number.NaN;
  cornerY = Number.NaN;

  constructor(x: number, y: number) {
    this.#x = x;
    this.#y = y;
  }

  /**
   * Moves the pen to the robot's position at the end of a tick.
   * @returns whether the previous position is a corner, which `cornerX` and `cornerY` contain
   */
  moveTo(x: number, y: number): boolean {
    const directionX = x - this.#x;
    const directionY = y - this.#y;
    if (directionX === 0 && directionY === 0) return false;
    const cross = directionX * this.#directionY - directionY * this.#directionX;
    const dot = directionX * this.#directionX + directionY * this.#directionY;
    // Compares with the direction at the last corner, so that a gentle curve has corners too. A
    // difference below a thousandth is a rounding error.
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
