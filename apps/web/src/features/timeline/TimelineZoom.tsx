/**
 * Buttons that zoom the timeline, and a bar that scrolls it. Wheel, fingers and keys do the same.
 */
import { Scan, ZoomIn, ZoomOut } from "lucide";
import { useEffect, useLayoutEffect, useRef, useState, type RefObject } from "react";
import { useTranslation } from "react-i18next";
import { useStore } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { Icon } from "../../ui/Icon.tsx";
import { IconButton } from "../../ui/Button.tsx";
import type { TimeWindow } from "./time-scale.ts";
import type { TimelineZoomStore } from "./timeline-zoom-store.ts";
import styles from "./timeline-zoom.module.css";
import { listenToTimelineZoom, ZOOM_STEP } from "./zoom-input.ts";
import { TimelineZoomController } from "./timeline-zoom-controller.ts";

/** Distance between each end of the timeline and of its axis, in px. */
const MARGIN = 10;

interface TimelineZoomProps {
  /** the element of the timeline */
  element: RefObject<HTMLElement | null>;
  zoom: TimelineZoomStore;
}

export function TimelineZoom({ element, zoom }: TimelineZoomProps) {
  const { t, ready } = useTranslation("runDetails", { useSuspense: false });
  const services = useServices();
  const [controller] = useState(
    () => new TimelineZoomController(services, zoom, () => widthOf(element)),
  );
  const window = useStore(zoom, (state) => state.window);

  useEffect(() => {
    if (element.current === null) return undefined;
    return listenToTimelineZoom(element.current, MARGIN, controller);
  }, [element, controller]);
  useEffect(() => services.run.subscribe(controller.follow), [services, controller]);

  if (!ready) return null;
  return (
    <>
      <fieldset className={styles["buttons"]} aria-label={t("timelineZoom.name")}>
        <IconButton
          size="small"
          label={t("timelineZoom.in")}
          onClick={() => controller.zoomHere(ZOOM_STEP)}
        >
          <Icon of={ZoomIn} />
        </IconButton>
        <IconButton
          size="small"
          label={t("timelineZoom.out")}
          disabled={window === null}
          onClick={() => controller.zoomHere(1 / ZOOM_STEP)}
        >
          <Icon of={ZoomOut} />
        </IconButton>
        <IconButton
          size="small"
          className={styles["whole"]}
          label={t("timelineZoom.fit")}
          disabled={window === null}
          onClick={() => controller.zoomHere(null)}
        >
          <Icon of={Scan} />
        </IconButton>
      </fieldset>
      {window !== null && (
        <ScrollBar
          window={window}
          whole={controller.whole}
          label={t("timelineZoom.part")}
          onScroll={controller.scrollTo}
        />
      )}
    </>
  );
}

/** Width of the axis, in px. */
function widthOf({ current }: RefObject<HTMLElement | null>): number {
  return (current?.clientWidth ?? 0) - 2 * MARGIN;
}

interface ScrollBarProps {
  window: TimeWindow;
  /** ticks of the whole axis */
  whole: number;
  label: string;
  onScroll: (from: number) => void;
}

/** A native scroll container, which supports mouse, touch and keyboard. */
function ScrollBar({ window, whole, label, onScroll }: ScrollBarProps) {
  const box = useRef<HTMLDivElement>(null);
  /** last scroll position in px: a scroll event at this position does not come from the user */
  const put = useRef(0);
  useLayoutEffect(() => {
    if (box.current === null) return;
    box.current.scrollLeft = (window.from / whole) * box.current.scrollWidth;
    put.current = box.current.scrollLeft;
  }, [window, whole]);
  return (
    <section
      ref={box}
      // Keyboard users can scroll the container only if it can receive the focus.
      // oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex
      tabIndex={0}
      aria-label={label}
      className={styles["scroll"]}
      onScroll={({ currentTarget: { scrollLeft, scrollWidth } }) => {
        if (Math.abs(scrollLeft - put.current) < 1) return;
        put.current = scrollLeft;
        onScroll((scrollLeft / scrollWidth) * whole);
      }}
    >
      <div style={{ inlineSize: `${(whole / window.span) * 100}%` }} />
    </section>
  );
}
