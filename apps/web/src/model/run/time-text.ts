/** A time of the run in words. In a file of its own, because the first screen loads it. */
import type { TFunction } from "i18next";
import { formatSeconds } from "../../text/numbers.ts";

const TICKS_PER_MINUTE = 3600;

/** A time of the run, as every part of the page says it: "12.4 s"; from one minute "208 min 16.0 s" */
export function timeText(t: TFunction, tick: number, language: string): string {
  const minutes = Math.floor(tick / TICKS_PER_MINUTE);
  const seconds = formatSeconds(tick % TICKS_PER_MINUTE, language);
  return minutes === 0
    ? t("timeline.at", { seconds })
    : t("timeline.atMinutes", { minutes, seconds });
}
