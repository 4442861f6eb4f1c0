/** Everything that the timeline draws at one size, computed from one state of the recording. */
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
  /** the last tick of the run */
  endTick: number;
}

/**
 * @param width width of the timeline, in px
 * @param window the displayed part; null for the whole run
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
 * A text that is equal for pictures that look equal to a pixel. In a long run, most changes are too
 * narrow to be visible.
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
