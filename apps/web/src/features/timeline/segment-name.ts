/** The name in a segment of the ribbon, and whether it fits. */
import type { TimelineDriver } from "@corridor/recording";
import type { TFunction } from "i18next";

/** Margin of a segment's name, width of a letter and width of a full-width character, in px. */
const NAME_MARGIN = 5;
const LETTER = 7;
const WIDE_CHARACTER = 12;

/** The name of a segment's driver; null if it has none. */
export function nameOf(t: TFunction, who: TimelineDriver): string | null {
  switch (who) {
    case "me":
      return t("timeline.me");
    case "remote":
      return t("timeline.remote");
    case "default":
      return t("timeline.otherwise");
    case "mixed":
      return null;
    default:
      return String(who + 1);
  }
}

/** @param width width of the segment, in px */
export function fits(name: string, width: number): boolean {
  return widthOf(name) <= width;
}

/** The width that a name needs, in px. */
export function widthOf(name: string): number {
  let needed = NAME_MARGIN;
  for (const character of name) needed += character >= "\u2e80" ? WIDE_CHARACTER : LETTER;
  return needed;
}
