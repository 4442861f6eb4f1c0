/** The timeline's picture for the width that an element has, painted anew at the pace of the store. */
import { useEffect, useState, type RefObject } from "react";
import type { TimelineStore } from "../../stores/timeline-store.ts";
import { pictureOf, type TimelinePicture } from "./picture.ts";

/** @returns null before the element was measured */
export function usePicture(
  timelines: TimelineStore,
  element: RefObject<HTMLElement | null>,
): TimelinePicture | null {
  const [picture, setPicture] = useState<TimelinePicture | null>(null);
  useEffect(() => {
    let width = 0;
    const paint = () => {
      if (width > 0) setPicture(pictureOf(timelines.timeline, width));
    };
    const measure = new ResizeObserver(([entry]) => {
      width = Math.round(entry?.contentRect.width ?? 0);
      paint();
    });
    if (element.current !== null) measure.observe(element.current);
    const endListening = timelines.listen(paint);
    return () => {
      measure.disconnect();
      endListening();
    };
  }, [timelines, element]);
  return picture;
}
