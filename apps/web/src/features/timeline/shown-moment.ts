/** What the timeline says of a moment in words: when it is, who drives, and what happens. */
import type { Timeline, TimelineEvent, Who } from "@corridor/recording";
import type { TFunction } from "i18next";
import { joinList } from "../../text/joined.ts";
import { formatSeconds } from "../../text/numbers.ts";

/** An event is told from just before it to a tenth of a second after it, in ticks. */
const BEFORE = 1;
const AFTER = 5;

export interface ShownMoment {
  tick: number;
  /** null before anybody drove */
  who: Who | null;
  /** null where nothing happens */
  event: TimelineEvent | null;
}

/** The moment at the end of a tick. */
export function momentAt(
  timeline: Pick<Timeline, "stretchAt" | "whoOf" | "eventsUpTo" | "eventAt">,
  tick: number,
): ShownMoment {
  const stretch = timeline.stretchAt(tick);
  const newest = timeline.eventsUpTo(tick + BEFORE) - 1;
  const event = newest < 0 ? null : timeline.eventAt(newest);
  return {
    tick,
    who: stretch < 0 ? null : timeline.whoOf(stretch),
    event: event !== null && tick - event.tick <= AFTER ? event : null,
  };
}

/** "12.4 s, line 2 drives, right 90" */
export function sayMoment(t: TFunction, { tick, who, event }: ShownMoment): string {
  const parts = [t("timeline.at", { seconds: formatSeconds(tick) })];
  if (who !== null) parts.push(sayWho(t, who));
  if (event !== null) parts.push(sayEvent(t, event));
  return joinList(t, parts);
}

function sayWho(t: TFunction, who: Who): string {
  return typeof who === "number"
    ? t("timeline.drives.line", { line: who + 1 })
    : t(`timeline.drives.${who}`);
}

/** What an event is called: "right 90", "bump", "goal reached". */
function sayEvent(t: TFunction, event: TimelineEvent): string {
  switch (event.kind) {
    case "turn":
      return t(`timeline.turn.${event.turn}`);
    case "edit":
      return t(`timeline.edit.${event.what}`);
    case "bump":
    case "goal":
      return t(`timeline.event.${event.kind}`);
  }
}
