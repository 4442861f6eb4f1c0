/** Zooms the stage around the position of the pointer: Ctrl and the wheel, or two fingers. */
import type { Point, ZoomBy } from "../../stage/page/stage-zoom.ts";
import { wheelZoom } from "../../ui/wheel-zoom.ts";

type Zoom = (by: ZoomBy, at: Point) => void;

/** @returns a function that removes the listeners */
export function listenToZoom(element: HTMLElement, zoom: Zoom): () => void {
  const end = new AbortController();
  const options = { signal: end.signal, passive: false };
  const placeOf = (clientX: number, clientY: number): Point => {
    const { left, top } = element.getBoundingClientRect();
    return { x: clientX - left, y: clientY - top };
  };
  element.addEventListener(
    "wheel",
    (event) => {
      if (!event.ctrlKey && !event.metaKey) return;
      event.preventDefault();
      zoom({ factor: wheelZoom(event) }, placeOf(event.clientX, event.clientY));
    },
    options,
  );
  let apart: number | null = null;
  const onTouch = (event: TouchEvent): void => {
    const [one, two] = event.touches;
    if (one === undefined || two === undefined || event.touches.length !== 2) {
      apart = null;
      return;
    }
    if (event.cancelable) event.preventDefault();
    const distance = Math.hypot(one.clientX - two.clientX, one.clientY - two.clientY);
    if (apart !== null && apart > 0 && distance > 0) {
      const [x, y] = [(one.clientX + two.clientX) / 2, (one.clientY + two.clientY) / 2];
      zoom({ factor: distance / apart }, placeOf(x, y));
    }
    apart = distance;
  };
  for (const type of ["touchstart", "touchmove", "touchend", "touchcancel"] as const) {
    element.addEventListener(type, onTouch, options);
  }
  return () => end.abort();
}
