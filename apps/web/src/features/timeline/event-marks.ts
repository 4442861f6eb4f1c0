/**
 * The events above the ribbon: turns, bumps, the goal, edits. Where two would overlap, the more
 * important one is displayed.
 */
import type { Timeline, TimelineEvent } from "@corridor/recording";
import { xOf, type TimeScale } from "./time-scale.ts";

/** Minimum distance between two marks, in px. */
const MARK_PX = 15;
/** Maximum number of neighbouring events that are compared. */
const MOST_WEIGHED = 64;

/** The ranks of events; the lowest is the most important. */
const RANK: Readonly<Record<TimelineEvent["kind"], number>> = {
  goal: 0,
  bump: 1,
  edit: 2,
  turn: 3,
};

/** The part of a timeline that is used here. */
export type Events = Pick<Timeline, "eventCount" | "eventAt" | "eventsUpTo">;

export interface EventMark {
  event: TimelineEvent;
  /** px from the left end to the middle of the mark */
  x: number;
  /** number of further events that the mark represents */
  more: number;
}

/** The marks from left to right, at least one mark's width apart. */
export function marksOf(timeline: Events, scale: TimeScale): EventMark[] {
  const leastTicks = (MARK_PX / scale.width) * scale.span;
  const marks: EventMark[] = [];
  let next = timeline.eventsUpTo(scale.from - 1);
  while (next < timeline.eventCount) {
    const event = mostImportant(timeline, next, leastTicks);
    if (event.tick > scale.from + scale.span) break;
    const after = timeline.eventsUpTo(Math.ceil(event.tick + leastTicks) - 1);
    marks.push({ event, x: xOf(scale, event.tick), more: after - next - 1 });
    next = after;
  }
  return marks;
}

/** The first event from an index on, unless a more important event would overlap it. */
function mostImportant(timeline: Events, index: number, leastTicks: number): TimelineEvent {
  let best = timeline.eventAt(index);
  const last = Math.min(timeline.eventCount, index + MOST_WEIGHED);
  for (let at = index + 1; at < last; at += 1) {
    const event = timeline.eventAt(at);
    if (event.tick - best.tick >= leastTicks) break;
    if (RANK[event.kind] < RANK[best.kind]) best = event;
  }
  return best;
}

/** The mark whose icon is under a position, in px from the left end; null if there is none. */
export function markUnder(marks: readonly EventMark[], x: number): EventMark | null {
  const reach = MARK_PX / 2;
  return marks.find((mark) => Math.abs(mark.x - x) <= reach) ?? null;
}
