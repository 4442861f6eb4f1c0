/**
 * The part of the run that the timeline displays. `TimelineZoom.tsx`, which changes it, loads
 * separately.
 */
import { createStore } from "zustand/vanilla";
import type { TimeWindow } from "./time-scale.ts";

interface TimelineZoomState {
  /** null while the whole run is displayed */
  window: TimeWindow | null;
  /** whether two fingers zoom, which does not scrub */
  isPinching: boolean;
}

export function createTimelineZoom() {
  return createStore<TimelineZoomState>()(() => ({ window: null, isPinching: false }));
}
export type TimelineZoomStore = ReturnType<typeof createTimelineZoom>;
