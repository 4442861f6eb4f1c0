/**
 * The timeline for keyboard and screen readers: an invisible native slider. Its value is written
 * directly to the DOM: React would render the whole timeline each second, and write all attributes
 * of the input.
 */
import { useEffectEvent, useLayoutEffect, type ComponentProps, type RefObject } from "react";
import { useTranslation } from "react-i18next";
import type { StoreApi } from "zustand";
import { tickText, type TickDescription } from "../../model/run/tick-description.ts";
import styles from "./run-timeline.module.css";

interface TimelineSliderProps extends Pick<
  ComponentProps<"input">,
  "onKeyDown" | "onFocus" | "onBlur"
> {
  inputRef: RefObject<HTMLInputElement | null>;
  displayed: StoreApi<TickDescription>;
  /** the last tick of the run in the current picture */
  endTick: number;
  /** called when the user moves the slider */
  onMove: (tick: number) => void;
}

export function TimelineSlider({
  inputRef,
  displayed,
  endTick,
  onMove,
  ...rest
}: TimelineSliderProps) {
  const { t, i18n } = useTranslation();
  const write = useEffectEvent((shown: TickDescription) => {
    const slider = inputRef.current;
    if (slider === null) return;
    slider.max = String(Math.max(1, shown.tick, endTick));
    slider.value = String(shown.tick);
    slider.setAttribute("aria-valuetext", tickText(t, shown, i18n.language));
  });
  useLayoutEffect(() => write(displayed.getState()), [displayed, endTick, t]);
  useLayoutEffect(() => displayed.subscribe((shown) => write(shown)), [displayed]);
  return (
    <input
      ref={inputRef}
      type="range"
      className={styles["slider"]}
      aria-label={t("timeline.name")}
      min={0}
      onInput={({ currentTarget }) => onMove(Number(currentTarget.value))}
      {...rest}
    />
  );
}
