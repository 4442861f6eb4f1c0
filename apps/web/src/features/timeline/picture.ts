/** Everything that the timeline draws at one size, from one look at the recording. */
import type { Timeline } from "@corridor/recording";
import { marksOf, type EventMark } from "./event-marks.ts";
import { ribbonOf, type Segment } from "./ribbon.ts";
import { axisOf, scaleOf, xOf, type AxisMark, type TimeScale } from "./time-scale.ts";

export interface TimelinePicture {
  scale: TimeScale;
  segments: readonly Segment[];
  marks: readonly EventMark[];
  axis: readonly AxisMark[];
  /** the run's last tick */
  endTick: number;
}

/** @param width of the timeline, in px */
export function pictureOf(timeline: Timeline, width: number): TimelinePicture {
  const { endTick } = timeline;
  const scale = scaleOf(endTick, width);
  return {
    scale,
    endTick,
    segments: ribbonOf(timeline, scale),
    marks: marksOf(timeline, scale),
    axis: axisOf(scale),
  };
}

/** The same text for as long as a picture of that width shows the same, to a pixel at the run's end. */
export function pictureMark(timeline: Timeline, width: number): string {
  const { endTick, stretchCount, eventCount } = timeline;
  const scale = scaleOf(endTick, width);
  const stretch = stretchCount - 1;
  return [
    width,
    scale.span,
    Math.round(xOf(scale, endTick)),
    stretchCount,
    ...(stretch < 0 ? [] : [timeline.tickOf(stretch), timeline.whoOf(stretch)]),
    eventCount,
    ...(eventCount === 0 ? [] : [timeline.eventAt(eventCount - 1).tick]),
  ].join(" ");
}
