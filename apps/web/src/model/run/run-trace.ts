/**
 * The displayed run with its whole trail, for exported pictures. It collects the throttled frames
 * of the panels; the stage is drawn elsewhere.
 */
import type { Snapshot } from "@corridor/protocol";
import { Trail } from "../../stage/drawing/trail.ts";
import type { Frame } from "../../stage/drawing/frame.ts";

/** Two numbers per bump: the newest 100 bumps. */
const MAX_BUMP_NUMBERS = 200;

export class RunTrace {
  readonly #trail = new Trail();
  #bumps: readonly number[] = [];
  #snapshot: Snapshot | null = null;

  add({ snapshot, corners, bumps, trailReset }: Frame): void {
    this.#trail.add(corners, snapshot.pose, trailReset);
    if (trailReset || bumps.length > 0) {
      const before = trailReset ? [] : this.#bumps;
      this.#bumps = [...before, ...bumps].slice(-MAX_BUMP_NUMBERS);
    }
    this.#snapshot = snapshot;
  }

  /**
   * The robot, its trail and its bumps (x and y alternating, in units); null before the first
   * frame.
   */
  take(): { snapshot: Snapshot; points: readonly number[]; bumps: readonly number[] } | null {
    if (this.#snapshot === null) return null;
    return { snapshot: this.#snapshot, points: this.#trail.points(), bumps: this.#bumps };
  }
}
