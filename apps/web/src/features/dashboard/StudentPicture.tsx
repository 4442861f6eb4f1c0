/** The picture of a student's maze, which the worker draws. */
import { useEffect, useId, useRef } from "react";
import { useContent } from "./dashboard-context.ts";
import styles from "./student-card.module.css";

export function StudentPicture({ student }: { student: number }) {
  const { dashboard } = useContent();
  const id = useId();
  const frame = useRef<HTMLDivElement>(null);
  useEffect(() => {
    const element = frame.current;
    if (element === null) return;
    // A canvas gives away its drawing once, so each mount has its own.
    const canvas = element.appendChild(document.createElement("canvas"));
    const offscreen = canvas.transferControlToOffscreen();
    dashboard.send({ type: "canvas", place: id, student, canvas: offscreen }, [offscreen]);
    const observer = new ResizeObserver(() => {
      const { devicePixelRatio } = window;
      dashboard.send({
        type: "canvas-size",
        place: id,
        width: Math.max(1, Math.round(element.clientWidth * devicePixelRatio)),
        height: Math.max(1, Math.round(element.clientHeight * devicePixelRatio)),
      });
    });
    observer.observe(element);
    return () => {
      observer.disconnect();
      dashboard.send({ type: "canvas-gone", place: id });
      canvas.remove();
    };
  }, [dashboard, id, student]);
  return <div ref={frame} className={styles["picture"]} aria-hidden="true" />;
}
