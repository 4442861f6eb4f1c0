/** Everything that the timeline draws at one size, from one look at the recording. */
import type { Timeline } from "@corridor/recording";
import { commandMarksOf, type CommandMark } from "./command-marks.ts";
import { marksOf, type EventMark } from "./event-marks.ts";
import { ribbonOf, type Segment } from "./ribbon.ts";
import {
  axisOf,
  scaleOf,
  xOf,
  type AxisMark,
  type TimeScale,
  type TimeWindow,
} from "./time-scale.ts";

export interface TimelinePicture {
  scale: TimeScale;
  segments: readonly Segment[];
  marks: readonly EventMark[];
  commands: readonly CommandMark[];
  axis: readonly AxisMark[];
  /** the run's last tick */
  endTick: number;
}

/**
 * @param width of the timeline, in px
 * @param window the part that is displayed; null for the whole run
 */
export function pictureOf(
  timeline: Timeline,
  width: number,
  window: TimeWindow | null = null,
): TimelinePicture {
  const { endTick } = timeline;
  const scale = window === null ? scaleOf(endTick, width) : { ...window, width, isPart: true };
  return {
    scale,
    endTick,
    segments: ribbonOf(timeline, scale),
    marks: marksOf(timeline, scale),
    commands: commandMarksOf(timeline.commands, scale, endTick),
    axis: axisOf(scale),
  };
}

/**
 * The same text for pictures that look the same, to a pixel: in a long run, most of what comes is too
 * narrow to be seen.
 */
export function pictureMark({
  scale,
  segments,
  marks,
  commands,
  endTick,
}: TimelinePicture): string {
  return [
    scale.width,
    scale.from,
    scale.span,
    Math.round(xOf(scale, endTick)),
    ...segments.map(({ who, x, width }) => `${who} ${Math.round(x)} ${Math.round(width)}`),
    ...marks.map(({ event, more }) => `${event.tick} ${more}`),
    ...commands.map(({ label, width, result }) => `${label} ${Math.round(width)} ${result}`),
  ].join();
}
