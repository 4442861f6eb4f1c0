/**
 * The robot's trail as corners: a straight line costs one point however long it is. What is not yet a
 * corner ends at the robot itself.
 */
export class Trail {
  #corners: number[] = [];
  #isReset = true;
  #x = Number.NaN;
  #y = Number.NaN;
  #wayX = 0;
  #wayY = 0;

  /** Begins anew where the robot stands. */
  reset(x: number, y: number): void {
    this.#corners = [x, y];
    this.#isReset = true;
    this.#x = x;
    this.#y = y;
    this.#wayX = 0;
    this.#wayY = 0;
  }

  /** Notes where the robot is at the end of a tick. */
  add(x: number, y: number): void {
    const wayX = x - this.#x;
    const wayY = y - this.#y;
    if (wayX === 0 && wayY === 0) return;
    const cross = wayX * this.#wayY - wayY * this.#wayX;
    const dot = wayX * this.#wayX + wayY * this.#wayY;
    // Compared with the way at the last corner, so that a gentle curve gets its corners too. A way
    // that differs by less than a thousandth is straight: rounding, not driving.
    if (dot <= 0 || cross * cross > 1e-6 * dot * dot) {
      this.#corners.push(this.#x, this.#y);
      this.#wayX = wayX;
      this.#wayY = wayY;
    }
    this.#x = x;
    this.#y = y;
  }

  /** Corners since the last call, and whether the trail began anew. */
  take(): { corners: number[]; trailReset: boolean } {
    const taken = { corners: this.#corners, trailReset: this.#isReset };
    this.#corners = [];
    this.#isReset = false;
    return taken;
  }
}
