/** What stands in a segment of the ribbon, and whether it has room there. */
import type { TimelineDriver } from "@corridor/recording";
import type { TFunction } from "i18next";

/** Room around a segment's name, and the widths of letters and of characters as wide as they are high, in px. */
const NAME_MARGIN = 5;
const LETTER = 7;
const WIDE_CHARACTER = 12;

/** What a segment is called: nothing rather than a part of a word. */
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

/** @param width of the segment, in px */
export function fits(name: string, width: number): boolean {
  return widthOf(name) <= width;
}

/** The room that a name needs, in px. */
export function widthOf(name: string): number {
  let needed = NAME_MARGIN;
  for (const character of name) needed += character >= "\u2e80" ? WIDE_CHARACTER : LETTER;
  return needed;
}
