/** The page's copy of the run's timeline. A file of its own: nobody needs it before there is a run. */
import { Timeline } from "@corridor/recording";
import type { TimelineStore } from "../../stores/timeline-store.ts";

/** Not while rendering: the first call lets listeners know. */
export function timelineOf(store: TimelineStore): Timeline {
  return store.open(() => new Timeline());
}
