/**
 * The ribbon of the timeline: who or which line drove, as segments that a screen can show. What is
 * narrower than a few pixels is one segment with its neighbours, so that a run of hours costs no more
 * than the screen is wide.
 */
import type { Timeline, TimelineDriver } from "@corridor/recording";
import { xOf, type TimeScale } from "./time-scale.ts";

/** Narrower stretches are shown together with those after them, in px. */
const LEAST_PX = 3;
/** Between two segments, in px. */
const GAP_PX = 1;

/** What of a timeline is read here. */
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
  /** the newest stretch, which may still grow */
  isNewest: boolean;
}

/** The segments of a run from the left to the right; they do not overlap. */
export function ribbonOf(timeline: Stretches, scale: TimeScale): Segment[] {
  const { segmentCount, endTick } = timeline;
  const leastTicks = (LEAST_PX / scale.width) * scale.span;
  const segments: Segment[] = [];
  const end = scale.from + scale.span;
  let next = Math.max(0, timeline.segmentAt(scale.from));
  while (next < segmentCount) {
    const from = Math.max(scale.from, timeline.tickOf(next));
    if (from > end) break;
    // All that begins and ends within the least width, but never the newest: it shows who drives now.
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

/** What is too narrow to be told from its neighbour is one with it. */
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
