/**
 * The timeline of a run: drivers and events, as a slider that displays any tick. A press or a drag
 * displays the tick under the pointer. A press on a mark displays the tick of its event.
 */
import { useRef, useState, type KeyboardEvent, type PointerEvent } from "react";
import { useTranslation } from "react-i18next";
import { useStore, type StoreApi } from "zustand";
import { useServices } from "../../model/use-services.ts";
import { commandUnder } from "./command-marks.ts";
import { markUnder } from "./event-marks.ts";
import { EventMarks } from "./EventMarks.tsx";
import type { TimelinePicture } from "./picture.ts";
import { Playhead } from "./Playhead.tsx";
import { Ribbon } from "./Ribbon.tsx";
import { Scrubber } from "./scrubber.ts";
import { describeTick, tickText, type TickDescription } from "../../model/run/tick-description.ts";
import { isProgramRefused } from "../../model/run/run-button.ts";
import { timelineKey } from "./timeline-keys.ts";
import { tickAt, xOf, type TimeScale } from "./time-scale.ts";
import { createTimelineZoom } from "./timeline-zoom-store.ts";
import { TimelineSlider } from "./TimelineSlider.tsx";
import runStyles from "./run-timeline.module.css";
import { timelineOf } from "../../model/run/timeline-of.ts";
import styles from "./timeline.module.css";
import { classNames } from "../../ui/class-names.ts";
import { deferredPart } from "../../ui/lazy-part.tsx";
import { usePicture } from "./use-picture.ts";
import { useDisplayedTick } from "../../model/use-displayed-tick.ts";

const TimelineZoom = deferredPart(async () => (await import("./TimelineZoom.tsx")).TimelineZoom);

/** Ticks of a run after which the zoom is needed. Before, it loads in the background. */
const LONG_TICKS = 300;

/** The text of the tooltip, and its position in px from the left end. */
interface Tip {
  x: number;
  text: string;
}

export function RunTimeline() {
  const { t, i18n } = useTranslation();
  const { challenge, run, simulator, timeline } = useServices();
  const bar = useRef<HTMLDivElement>(null);
  const track = useRef<HTMLDivElement>(null);
  const slider = useRef<HTMLInputElement>(null);
  const [zoom] = useState(createTimelineZoom);
  const picture = usePicture(track, zoom);
  const isFresh = useStore(run, ({ nowTick }) => nowTick === 0);
  const isLong = useStore(run, ({ nowTick }) => nowTick >= LONG_TICKS);
  const displayed = useDisplayedTick();
  const eventKind = useStore(displayed, ({ event }) => event?.kind);
  const isNow = useStore(run, ({ view }) => view === "now");
  const [pointed, setPointed] = useState<Tip | null>(null);
  const [isFocused, setFocused] = useState(false);
  const [scrubber] = useState(() => new Scrubber(simulator));

  /**
   * The tick under the pointer: that of a mark, else that of the position; at most the last tick.
   */
  function tickUnder(event: PointerEvent<HTMLElement>, picture: TimelinePicture) {
    const { scale, marks, commands, endTick } = picture;
    const box = track.current?.getBoundingClientRect();
    if (box === undefined) return 0;
    const x = event.clientX - box.left;
    const marked =
      event.clientY < box.top
        ? markUnder(marks, x)?.event.tick
        : // A press on a command's number selects its start. A drag continues tick by tick.
          event.type === "pointerdown"
          ? commandUnder(commands, x)?.tick
          : undefined;
    return Math.min(marked ?? tickAt(scale, x), endTick);
  }

  function follow(event: PointerEvent<HTMLElement>): void {
    if (picture === null || picture.endTick === 0 || zoom.getState().isPinching) return;
    const tick = tickUnder(event, picture);
    const isHeld = event.currentTarget.hasPointerCapture(event.pointerId);
    if (isHeld) show(tick);
    setPointed({
      x: xOf(picture.scale, tick),
      text: `${tickText(t, describeTick(timelineOf(timeline), tick, run.getState().snapshot), i18n.language)}${moreAt(picture, tick)}`,
    });
  }

  function show(tick: number): void {
    if (tick < run.getState().nowTick) {
      scrubber.show(tick);
      return;
    }
    scrubber.stop();
    if (run.getState().view !== "now") simulator.send({ type: "now" });
  }

  function press(event: PointerEvent<HTMLElement>): void {
    if (event.button !== 0 || !event.isPrimary || picture === null || picture.endTick === 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    // Moves the focus to the slider, so that the arrow keys continue from here.
    event.preventDefault();
    slider.current?.focus();
    follow(event);
  }

  function onKey(event: KeyboardEvent): void {
    if (event.altKey || event.ctrlKey || event.metaKey) return;
    const { snapshot, nowTick } = run.getState();
    const isRefused = isProgramRefused(challenge.getState().rights);
    const shownTick = snapshot?.tick ?? 0;
    const message = timelineKey(event.key, shownTick, nowTick, event.shiftKey, isRefused);
    if (message === null) return;
    event.preventDefault();
    setFocused(true);
    scrubber.stop();
    if (nowTick > 0) simulator.send(message);
  }

  return (
    <>
      <div
        ref={bar}
        className={classNames(styles["timeline"], runStyles["bar"])}
        data-focused={isFocused || undefined}
        onPointerDown={press}
        onPointerMove={follow}
        onPointerUp={(event) => {
          if (event.pointerType !== "mouse") setPointed(null);
        }}
        onPointerLeave={() => setPointed(null)}
        onPointerCancel={() => setPointed(null)}
      >
        {/* The slider receives no pointer events: the element around it handles them. */}
        <TimelineSlider
          inputRef={slider}
          displayed={displayed}
          endTick={picture?.endTick ?? 0}
          onMove={show}
          onKeyDown={onKey}
          onFocus={(event) => setFocused(event.currentTarget.matches(":focus-visible"))}
          onBlur={() => setFocused(false)}
        />
        <div ref={track} className={styles["body"]}>
          {picture !== null && (
            <>
              <Ribbon picture={picture} isNow={isNow} />
              {/* Before the run, a sentence is in the place of the marks. */}
              {picture.endTick > 0 && (
                <>
                  <EventMarks marks={picture.marks} />
                  <Playhead
                    scale={picture.scale}
                    event={eventKind === "goal" || eventKind === "bump" ? eventKind : null}
                  />
                </>
              )}
              {pointed !== null ? (
                <TimelineTip {...pointed} width={picture.scale.width} />
              ) : (
                isFocused && <FocusTip displayed={displayed} scale={picture.scale} />
              )}
            </>
          )}
        </div>
      </div>
      {!isFresh && <TimelineZoom isWanted={isLong} element={bar} zoom={zoom} />}
    </>
  );
}

/** The number of further events in the mark of a tick: " (+3)"; empty if there are none. */
function moreAt({ marks }: TimelinePicture, tick: number): string {
  const more = marks.find(({ event }) => event.tick === tick)?.more ?? 0;
  return more === 0 ? "" : ` (+${more})`;
}

/** Displays what the slider announces to screen readers. */
function FocusTip({
  displayed,
  scale,
}: {
  displayed: StoreApi<TickDescription>;
  scale: TimeScale;
}) {
  const { t, i18n } = useTranslation();
  const shown = useStore(displayed);
  return (
    <TimelineTip
      x={xOf(scale, shown.tick)}
      text={tickText(t, shown, i18n.language)}
      width={scale.width}
    />
  );
}

/** A tooltip above the timeline, aligned so that it does not extend beyond the ends. */
function TimelineTip({ x, text, width }: Tip & { width: number }) {
  const transform = `translateX(${(-100 * x) / width}%)`;
  return (
    <span
      className={runStyles["tip"]}
      style={{ insetInlineStart: x, transform }}
      aria-hidden="true"
    >
      <bdi>{text}</bdi>
    </span>
  );
}
