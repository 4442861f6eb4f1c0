/**
 * Input that zooms and moves a timeline: Ctrl and the wheel, a horizontal wheel, two fingers, and
 * the keys + - 0.
 */
import { wheelZoom } from "../../ui/wheel-zoom.ts";

export interface ZoomActions {
  /** zooms around a position, as a share of the width from 0 to 1 */
  zoom: (factor: number, share: number) => void;
  /** zooms around the displayed tick; null: the whole run */
  zoomHere: (factor: number | null) => void;
  /** moves by a share of the displayed part */
  move: (share: number) => void;
  /** two fingers have touched or left the timeline */
  pinch: (isPinching: boolean) => void;
}

/** Zoom factor of one press of a key or a button. */
export const ZOOM_STEP = 2;

const keys: Readonly<Record<string, number | null>> = {
  "+": ZOOM_STEP,
  "=": ZOOM_STEP,
  "-": 1 / ZOOM_STEP,
  "0": null,
};

/**
 * @param element the element of the timeline
 * @param margin px between each end of the element and of its axis
 * @returns a function that removes the listeners
 */
export function listenToTimelineZoom(
  element: HTMLElement,
  margin: number,
  { zoom, zoomHere, move, pinch }: ZoomActions,
): () => void {
  const end = new AbortController();
  const options = { signal: end.signal, passive: false };
  const shareOf = (clientX: number): number => {
    const { left, width } = element.getBoundingClientRect();
    return Math.min(1, Math.max(0, (clientX - left - margin) / (width - 2 * margin)));
  };
  element.addEventListener(
    "wheel",
    (event) => {
      if (event.ctrlKey || event.metaKey) {
        event.preventDefault();
        zoom(wheelZoom(event), shareOf(event.clientX));
        return;
      }
      const sideways = event.shiftKey && event.deltaX === 0 ? event.deltaY : event.deltaX;
      if (sideways === 0) return;
      event.preventDefault();
      move(sideways / element.clientWidth);
    },
    options,
  );
  let before: { apart: number; share: number } | null = null;
  const onTouch = (event: TouchEvent): void => {
    const [one, two] = event.touches;
    if (one === undefined || two === undefined || event.touches.length !== 2) {
      if (before !== null) pinch(false);
      before = null;
      return;
    }
    if (event.cancelable) event.preventDefault();
    const apart = Math.max(1, Math.abs(one.clientX - two.clientX));
    const share = shareOf((one.clientX + two.clientX) / 2);
    if (before === null) pinch(true);
    else {
      move(before.share - share);
      zoom(apart / before.apart, share);
    }
    before = { apart, share };
  };
  for (const type of ["touchstart", "touchmove", "touchend", "touchcancel"] as const) {
    element.addEventListener(type, onTouch, options);
  }
  element.addEventListener(
    "keydown",
    (event) => {
      const factor = keys[event.key];
      if (factor === undefined || event.altKey || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      // Elsewhere, the same keys zoom the maze.
      event.stopPropagation();
      zoomHere(factor);
    },
    options,
  );
  return () => end.abort();
}
