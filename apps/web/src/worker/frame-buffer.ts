/**
 * Frames that wait to be drawn or sent: the newest one, with all that the trail gained meanwhile.
 * Whoever takes them may be much slower than the run, or hidden for hours.
 */
import type { Frame } from "./worker-messages.ts";

/** Of what was missed, so many of the newest corners and bumps are kept. */
const MAX_CORNERS = 20_000;
const MAX_BUMPS = 100;

export class FrameBuffer {
  #corners: number[] = [];
  #bumps: number[] = [];
  /** the newest bumps since the trail began, those that were taken too */
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
      // A line across what is missing would be a way that the robot never drove.
      this.#trailReset = true;
      // The bumps that are drawn go with the trail, and have to come again.
      this.#bumps = [...this.#allBumps];
    }
    this.#frame = frame;
  }

  /** The newest frame, whether it was taken before or not; null before the first. */
  get newest(): Frame | null {
    return this.#frame;
  }

  /**
   * The newest frame, with all that the trail gained since the last call; null before the first
   * frame. Each call takes the corners away.
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
