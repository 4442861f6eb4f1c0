/** What a key asks for while the timeline has the focus (DESIGN-LANGUAGE: keys). */
import type { ToWorker } from "../../worker/worker-messages.ts";

/** What Page Up and Page Down skip: 10 s, in ticks. */
const PAGE = 600;

/**
 * @param shownTick the moment that is shown, and `nowTick` the newest one
 * @param isShift one tick instead of one decision
 * @returns what to ask of the simulator; null when the key is not the timeline's
 */
export function timelineKey(
  key: string,
  shownTick: number,
  nowTick: number,
  isShift = false,
): ToWorker | null {
  if (isShift) {
    const isBack = key === "ArrowLeft" || key === "ArrowDown";
    if (isBack) return { type: "seek", tick: Math.max(0, shownTick - 1) };
    if (key !== "ArrowRight" && key !== "ArrowUp") return null;
    return shownTick < nowTick
      ? { type: "seek", tick: shownTick + 1 }
      : { type: "step", length: "tick" };
  }
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
