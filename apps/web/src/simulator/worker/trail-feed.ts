/**
 * The trail and the bumps up to the displayed tick, sent in pieces: the new part on the way
 * forward, all of it after a jump.
 */
import type { PositionLog } from "@corridor/recording";
import { MAX_BUMPS, MAX_CORNERS, type Frame } from "../../stage/drawing/frame.ts";

type Places = Pick<PositionLog, "countUpTo" | "slice">;

export class TrailFeed {
  #corners = 0;
  #bumps = 0;
  #isReset = true;

  /** Another run: everything is sent again. */
  begin(): void {
    this.#isReset = true;
  }

  /** Changes of the trail from the tick of the last call to the end of `tick`. */
  take(
    { corners, bumps }: { corners: Places; bumps: Places },
    tick: number,
  ): Pick<Frame, "corners" | "bumps" | "trailReset"> {
    const cornerCount = corners.countUpTo(tick);
    const bumpCount = bumps.countUpTo(tick);
    const isBack = cornerCount < this.#corners || bumpCount < this.#bumps;
    // A jump forward over more than is drawn costs no more than one back.
    const isFarAhead = cornerCount - this.#corners > MAX_CORNERS;
    const trailReset = this.#isReset || isBack || isFarAhead;
    if (trailReset) {
      this.#corners = Math.max(0, cornerCount - MAX_CORNERS);
      this.#bumps = 0;
    }
    const taken = {
      corners: corners.slice(this.#corners, cornerCount),
      bumps: bumps.slice(Math.max(this.#bumps, bumpCount - MAX_BUMPS), bumpCount),
      trailReset,
    };
    this.#corners = cornerCount;
    this.#bumps = bumpCount;
    this.#isReset = false;
    return taken;
  }
}
