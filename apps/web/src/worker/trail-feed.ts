/**
 * The trail and the bumps up to the shown moment, sent piece by piece: on the way forward what was
 * gained, after a jump all of it anew.
 */
import type { PositionLog } from "@corridor/recording";
import type { Frame } from "./worker-messages.ts";

type Places = Pick<PositionLog, "countUpTo" | "slice">;

/** After a jump so many of the newest are sent: as many as are drawn, and quick to draw. */
const MAX_CORNERS = 20_000;
const MAX_BUMPS = 100;

export class TrailFeed {
  #corners = 0;
  #bumps = 0;
  #isReset = true;

  /** Another run: what was sent before is of no use. */
  begin(): void {
    this.#isReset = true;
  }

  /** What the trail gained from the moment of the last call to the one at the end of `tick`. */
  take(
    { corners, bumps }: { corners: Places; bumps: Places },
    tick: number,
  ): Pick<Frame, "corners" | "bumps" | "trailReset"> {
    const cornerCount = corners.countUpTo(tick);
    const bumpCount = bumps.countUpTo(tick);
    const isBack = cornerCount < this.#corners || bumpCount < this.#bumps;
    // Over more than is drawn, a jump forward costs no more than one back.
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
