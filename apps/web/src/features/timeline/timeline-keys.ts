/** What a key asks for while the timeline has the focus (DESIGN-LANGUAGE: keys). */
import type { ToWorker } from "../../worker/worker-messages.ts";

/** What Page Up and Page Down skip: 10 s, in ticks. */
const PAGE = 600;

/**
 * @param shownTick the moment that is shown, and `nowTick` the newest one
 * @returns what to ask of the simulator; null when the key is not the timeline's
 */
export function timelineKey(key: string, shownTick: number, nowTick: number): ToWorker | null {
  switch (key) {
    case "ArrowLeft":
    case "ArrowDown":
      return { type: "seek-step", by: -1 };
    case "ArrowRight":
    case "ArrowUp":
      return { type: "seek-step", by: 1 };
    case "Home":
      return { type: "seek", tick: 0 };
    case "End":
      return { type: "now" };
    case "PageDown":
      return { type: "seek", tick: Math.max(0, shownTick - PAGE) };
    case "PageUp":
      return shownTick + PAGE >= nowTick
        ? { type: "now" }
        : { type: "seek", tick: shownTick + PAGE };
    default:
      return null;
  }
}
