/** The request of a key while the timeline has the focus. */
import type { ToWorker } from "../../simulator/protocol/worker-messages.ts";

/** Ticks that Page Up and Page Down skip: 10 s. */
const PAGE = 600;

/**
 * @param shownTick the displayed tick
 * @param nowTick the newest tick
 * @param isShift moves by one tick instead of one decision
 * @param isRefused whether the task refuses the driver Program, which would continue from now
 * @returns the request to the simulator; null if the timeline does not use the key
 */
export function timelineKey(
  key: string,
  shownTick: number,
  nowTick: number,
  isShift = false,
  isRefused = false,
): ToWorker | null {
  if (isRefused && shownTick >= nowTick && (key === "ArrowRight" || key === "ArrowUp")) return null;
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
