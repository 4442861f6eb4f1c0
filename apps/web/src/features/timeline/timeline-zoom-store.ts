/** Which part of the run the timeline displays. What changes it comes in a file of its own (`TimelineZoom.tsx`). */
import { createStore } from "zustand/vanilla";
import type { TimeWindow } from "./time-scale.ts";

interface TimelineZoomState {
  /** null: the whole run */
  window: TimeWindow | null;
  /** two fingers zoom: they do not scrub */
  isPinching: boolean;
}

export function createTimelineZoom() {
  return createStore<TimelineZoomState>()(() => ({ window: null, isPinching: false }));
}
export type TimelineZoomStore = ReturnType<typeof createTimelineZoom>;
