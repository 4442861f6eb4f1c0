/**
 * The place of the timeline. Before a run it is an empty track with its axis; the run's timeline
 * loads once there is a run.
 */
import { useDeferredValue, useEffect, useRef, useState } from "react";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { deferredPart } from "../../ui/lazy-part.tsx";
import { axisOf, scaleOf } from "./time-scale.ts";
import { TimelineAxis } from "./TimelineAxis.tsx";
import styles from "./timeline.module.css";

const RunTimeline = deferredPart(async () => (await import("./RunTimeline.tsx")).RunTimeline);

export function TimelineBar() {
  const { run } = useServices();
  const hasRun = useStore(run, ({ nowTick }) => nowTick > 0);
  // A restored run can be older than the page. Its timeline loads after the first render, so that
  // it does not compete with the page.
  const isAfterFirstRender = useDeferredValue(true, false);
  return (
    <div className={styles["place"]}>
      <RunTimeline isWanted={isAfterFirstRender && hasRun}>
        <EmptyTimeline />
      </RunTimeline>
    </div>
  );
}

function EmptyTimeline() {
  const track = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(0);
  useEffect(() => {
    const measure = new ResizeObserver(([entry]) => {
      setWidth(Math.round(entry?.contentRect.width ?? 0));
    });
    if (track.current !== null) measure.observe(track.current);
    return () => measure.disconnect();
  }, []);
  const scale = scaleOf(0, width);
  return (
    <div className={styles["timeline"]}>
      <div ref={track} className={styles["body"]}>
        {width > 0 && (
          <svg className={styles["picture"]} aria-hidden="true">
            <TimelineAxis scale={scale} marks={axisOf(scale)} />
          </svg>
        )}
      </div>
    </div>
  );
}
