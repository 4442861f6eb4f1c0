/**
 * The events that the timeline has room to show above its ribbon: turns, bumps, the goal, edits. Where
 * two would overlap, the one that says more is shown.
 */
import type { Timeline, TimelineEvent } from "@corridor/recording";
import { xOf, type TimeScale } from "./time-scale.ts";

/** Two marks stand at least this far apart, in px. */
const MARK_PX = 15;
/** More neighbours than these are not weighed against each other. */
const MOST_WEIGHED = 64;

/** What says more comes first. */
const RANK: Readonly<Record<TimelineEvent["kind"], number>> = {
  goal: 0,
  bump: 1,
  edit: 2,
  turn: 3,
};

/** What of a timeline is read here. */
export type Events = Pick<Timeline, "eventCount" | "eventAt" | "eventsUpTo">;

export interface EventMark {
  event: TimelineEvent;
  /** px from the left end to its middle */
  x: number;
  /** how many that would overlap it are one mark with it */
  more: number;
}

/** Marks from the left to the right, none closer to another than it is wide. */
export function marksOf(timeline: Events, scale: TimeScale): EventMark[] {
  const leastTicks = (MARK_PX / scale.width) * scale.span;
  const marks: EventMark[] = [];
  let next = timeline.eventsUpTo(scale.from - 1);
  while (next < timeline.eventCount) {
    const event = mostTelling(timeline, next, leastTicks);
    if (event.tick > scale.from + scale.span) break;
    const after = timeline.eventsUpTo(Math.ceil(event.tick + leastTicks) - 1);
    marks.push({ event, x: xOf(scale, event.tick), more: after - next - 1 });
    next = after;
  }
  return marks;
}

/** The first event from an index on, unless one that it would hide says more. */
function mostTelling(timeline: Events, index: number, leastTicks: number): TimelineEvent {
  let best = timeline.eventAt(index);
  const last = Math.min(timeline.eventCount, index + MOST_WEIGHED);
  for (let at = index + 1; at < last; at += 1) {
    const event = timeline.eventAt(at);
    if (event.tick - best.tick >= leastTicks) break;
    if (RANK[event.kind] < RANK[best.kind]) best = event;
  }
  return best;
}

/** The mark whose picture lies under a place, in px from the left end; null where there is none. */
export function markUnder(marks: readonly EventMark[], x: number): EventMark | null {
  const reach = MARK_PX / 2;
  return marks.find((mark) => Math.abs(mark.x - x) <= reach) ?? null;
}
