/** The page's copy of the run's timeline, in its own file because only a run needs it. */
import { Timeline } from "@corridor/recording";
import type { TimelineStore } from "./timeline-store.ts";

/** Do not call while rendering: the first call notifies listeners. */
export function timelineOf(store: TimelineStore): Timeline {
  return store.open(() => new Timeline());
}
