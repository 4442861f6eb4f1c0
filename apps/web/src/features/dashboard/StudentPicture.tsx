/** The picture of a student's maze, which the worker draws. */
import { useEffect, useId, useRef } from "react";
import type { Dashboard } from "../../model/classroom/dashboard.ts";
import { useContent } from "./dashboard-context.ts";
import styles from "./student-card.module.css";

/** Pictures this close to the view are drawn, so that none appears late. */
const NEAR = "200px";

export function StudentPicture({ student }: { student: number }) {
  const { dashboard } = useContent();
  const id = useId();
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = frame.current;
    if (element === null) return;
    let remove: (() => void) | null = null;
    // A canvas costs the browser work in every frame, even out of view.
    const visibility = new IntersectionObserver(
      (entries) => {
        const isShown = entries.at(-1)?.isIntersecting === true;
        if (isShown) remove ??= addCanvas(element, { dashboard, place: id, student });
        else {
          remove?.();
          remove = null;
        }
      },
      { rootMargin: NEAR },
    );
    visibility.observe(element);
    return () => {
      visibility.disconnect();
      remove?.();
    };
  }, [dashboard, id, student]);
  return <div ref={frame} className={styles["picture"]} aria-hidden="true" />;
}

interface Picture {
  dashboard: Dashboard;
  place: string;
  student: number;
}

/** @returns a function that removes the canvas */
function addCanvas(element: HTMLElement, { dashboard, place, student }: Picture): () => void {
  // A canvas gives away its drawing once, so each picture has its own.
  const canvas = element.appendChild(document.createElement("canvas"));
  const offscreen = canvas.transferControlToOffscreen();
  dashboard.send({ type: "canvas", place, student, canvas: offscreen }, [offscreen]);
  const observer = new ResizeObserver(() => {
    const { devicePixelRatio } = window;
    dashboard.send({
      type: "canvas-size",
      place,
      width: Math.max(1, Math.round(element.clientWidth * devicePixelRatio)),
      height: Math.max(1, Math.round(element.clientHeight * devicePixelRatio)),
    });
  });
  observer.observe(element);
  return () => {
    observer.disconnect();
    dashboard.send({ type: "canvas-gone", place });
    canvas.remove();
  };
}
