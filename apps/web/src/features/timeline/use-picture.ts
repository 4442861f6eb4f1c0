/**
 * The timeline's picture for the width of an element. While the robot drives, it is rendered again
 * only if something has moved by a pixel. Otherwise it is exact to the tick.
 */
import { useLayoutEffect, useState, type RefObject } from "react";
import { createStore, useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import type { TimelineZoomStore } from "./timeline-zoom-store.ts";
import { pictureMark, pictureOf, type TimelinePicture } from "./picture.ts";
import { timelineOf } from "../../model/run/timeline-of.ts";

/** @returns null before the element is measured */
export function usePicture(
  element: RefObject<HTMLElement | null>,
  zoom: TimelineZoomStore,
): TimelinePicture | null {
  const { run, timeline: timelines } = useServices();
  // A store renders in the same frame as the run store. An update of React state would render
  // later.
  const [shown] = useState(() => createStore<{ picture: TimelinePicture | null }>(() => NOTHING));
  // Before the browser paints, because the picture replaces the empty track.
  useLayoutEffect(() => {
    let width = element.current?.clientWidth ?? 0;
    let painted = "";
    const paint = () => {
      if (width === 0) return;
      const isRunning = run.getState().snapshot?.state === "running";
      const next = pictureOf(timelineOf(timelines), width, zoom.getState().window);
      const mark = pictureMark(next) + (isRunning ? "" : ` ${next.endTick}`);
      if (mark === painted) return;
      painted = mark;
      shown.setState({ picture: next });
    };
    const measure = new ResizeObserver(([entry]) => {
      width = Math.round(entry?.contentRect.width ?? 0);
      paint();
    });
    if (element.current !== null) measure.observe(element.current);
    paint();
    const endListening = timelines.listen(paint);
    const endZoom = zoom.subscribe(paint);
    return () => {
      measure.disconnect();
      endListening();
      endZoom();
    };
  }, [run, timelines, element, shown, zoom]);
  return useStore(shown).picture;
}

const NOTHING = { picture: null };
