/** Changes the displayed part of the run, as the user requests and as the displayed tick moves. */
import type { RunState, RunStore } from "../../model/run/run-store.ts";
import type { TimelineStore } from "../../model/run/timeline-store.ts";
import { scaleOf, type TimeWindow } from "./time-scale.ts";
import { timelineOf } from "../../model/run/timeline-of.ts";
import type { TimelineZoomStore } from "./timeline-zoom-store.ts";
import type { ZoomActions } from "./zoom-input.ts";
import { following, holds, movedTo, zoomedBy, type Zoomed } from "./zoom-window.ts";

interface Sources {
  run: RunStore;
  timeline: TimelineStore;
}

export class TimelineZoomController implements ZoomActions {
  readonly #sources: Sources;
  readonly #zoom: TimelineZoomStore;
  readonly #width: () => number;

  /**
   * @param width measures the axis in px. This forces a layout, so that `follow` avoids it for most
   * frames.
   */
  constructor(sources: Sources, zoom: TimelineZoomStore, width: () => number) {
    this.#sources = sources;
    this.#zoom = zoom;
    this.#width = width;
  }

  /** Ticks of the whole axis. */
  get whole(): number {
    const { endTick, width } = this.#now;
    return scaleOf(endTick, width).span;
  }

  readonly zoom = (factor: number, share: number): void => {
    const { from, span } = this.#displayed;
    this.#show(zoomedBy(this.#now, factor, from + share * span, share));
  };

  readonly zoomHere = (factor: number | null): void => {
    if (factor === null) return this.#show(null);
    const tick = this.#sources.run.getState().snapshot?.tick ?? 0;
    const { from, span } = this.#displayed;
    const share = (tick - from) / span;
    // A displayed tick outside of the part moves to the middle.
    this.#show(zoomedBy(this.#now, factor, tick, share < 0 || share > 1 ? 0.5 : share));
  };

  readonly move = (share: number): void => {
    const { from, span } = this.#displayed;
    this.#show(movedTo(this.#now, from + share * span));
  };

  readonly scrollTo = (from: number): void => this.#show(movedTo(this.#now, from));

  readonly pinch = (isPinching: boolean): void => this.#zoom.setState({ isPinching });

  /**
   * Keeps the displayed tick in view, unless the user views another part while the robot drives.
   */
  readonly follow = ({ snapshot, view, nowTick }: RunState, before: RunState): void => {
    const { window } = this.#zoom.getState();
    if (window === null || snapshot === null) return;
    // A new run is displayed as a whole.
    if (nowTick === 0 || nowTick < window.from) return this.#show(null);
    const tickBefore = before.snapshot?.tick ?? 0;
    if (snapshot.tick === tickBefore || holds(window, snapshot.tick)) return;
    const isLive = view === "now" && snapshot.state === "running";
    if (isLive && !holds(window, tickBefore)) return;
    const now = this.#now;
    // The timeline is updated one frame after the displayed tick.
    const endTick = Math.max(now.endTick, nowTick);
    this.#show(following({ ...now, endTick }, snapshot.tick));
  };

  get #now(): Zoomed {
    const { endTick } = timelineOf(this.#sources.timeline);
    return { window: this.#zoom.getState().window, endTick, width: this.#width() };
  }

  get #displayed(): Pick<TimeWindow, "from" | "span"> {
    const { window, endTick, width } = this.#now;
    return window ?? scaleOf(endTick, width);
  }

  #show(window: TimeWindow | null): void {
    this.#zoom.setState({ window });
  }
}
