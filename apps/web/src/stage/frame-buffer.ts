/**
 * Frames that wait to be drawn or sent: the newest one, with everything that the trail gained
 * meanwhile. The consumer may be much slower than the run, or hidden for hours.
 */
import { MAX_BUMPS, MAX_CORNERS, type Frame } from "./drawing/frame.ts";

export class FrameBuffer {
  #corners: number[] = [];
  #bumps: number[] = [];
  /** the newest bumps since the trail started, including those already taken */
  #allBumps: number[] = [];
  #trailReset = false;
  #frame: Frame | null = null;

  add(frame: Frame): void {
    if (frame.trailReset) {
      this.#corners = [];
      this.#bumps = [];
      this.#allBumps = [];
      this.#trailReset = true;
    }
    for (const value of frame.corners) this.#corners.push(value);
    if (frame.bumps.length > 0) {
      this.#bumps = [...this.#bumps, ...frame.bumps].slice(-2 * MAX_BUMPS);
      this.#allBumps = [...this.#allBumps, ...frame.bumps].slice(-2 * MAX_BUMPS);
    }
    const tooMany = this.#corners.length - 2 * MAX_CORNERS;
    if (tooMany > 0) {
      this.#corners.splice(0, tooMany);
      // A line across the gap would be a path that the robot never drove.
      this.#trailReset = true;
      // A trail reset removes the drawn bumps, so they are sent again.
      this.#bumps = [...this.#allBumps];
    }
    this.#frame = frame;
  }

  /** The newest frame, whether it was taken before or not; null before the first. */
  get newest(): Frame | null {
    return this.#frame;
  }

  /**
   * Takes the newest frame, with everything that the trail gained since the last call; null before
   * the first frame.
   */
  take(): Frame | null {
    if (this.#frame === null) return null;
    const frame: Frame = {
      ...this.#frame,
      corners: this.#corners,
      bumps: this.#bumps,
      trailReset: this.#trailReset,
    };
    this.#corners = [];
    this.#bumps = [];
    this.#trailReset = false;
    return frame;
  }
}
