/**
 * The ribbon of the timeline: which driver or line drove, as visible segments. Narrow stretches are
 * merged, so that the number of segments depends on the width of the screen, not on the length of
 * the run.
 */
import type { Timeline, TimelineDriver } from "@corridor/recording";
import { xOf, type TimeScale } from "./time-scale.ts";

/** Minimum width in px; narrower stretches are merged with those after them. */
const LEAST_PX = 3;
/** Distance between two segments, in px. */
const GAP_PX = 1;

/** The part of a timeline that is used here. */
export type Stretches = Pick<
  Timeline,
  "segmentCount" | "endTick" | "tickOf" | "driverOf" | "segmentAt"
>;

export interface Segment {
  who: TimelineDriver;
  /** px from the left end */
  x: number;
  /** px, at least 1 */
  width: number;
  /** the newest stretch, which can still grow */
  isNewest: boolean;
}

/** The segments of a run from left to right, without overlap. */
export function ribbonOf(timeline: Stretches, scale: TimeScale): Segment[] {
  const { segmentCount, endTick } = timeline;
  const leastTicks = (LEAST_PX / scale.width) * scale.span;
  const segments: Segment[] = [];
  const end = scale.from + scale.span;
  let next = Math.max(0, timeline.segmentAt(scale.from));
  while (next < segmentCount) {
    const from = Math.max(scale.from, timeline.tickOf(next));
    if (from > end) break;
    // Merges the stretches that start and end within the minimum width, but never the newest, which
    // shows the current driver.
    const reached = Math.min(timeline.segmentAt(from + leastTicks), segmentCount - 1);
    const isSingle = reached <= next + 1;
    const after = isSingle ? next + 1 : reached;
    const until = Math.min(end, after < segmentCount ? timeline.tickOf(after) : endTick);
    add(segments, {
      who: isSingle ? timeline.driverOf(next) : "mixed",
      x: xOf(scale, from),
      width: Math.max(1, xOf(scale, until) - xOf(scale, from) - GAP_PX),
      isNewest: after === segmentCount,
    });
    next = after;
  }
  return segments;
}

/**
 * Adds a segment, or merges it into the previous one if both are mixed or too narrow. The newest
 * segment is never merged.
 */
function add(segments: Segment[], segment: Segment): void {
  const last = segments.at(-1);
  if (last === undefined || segment.isNewest || !isBlurred(last) || !isBlurred(segment)) {
    segments.push(segment);
    return;
  }
  last.who = "mixed";
  last.width = segment.x + segment.width - last.x;
}

function isBlurred({ who, width }: Segment): boolean {
  return who === "mixed" || width + GAP_PX < LEAST_PX;
}
