/**
 * Ticks and pixels of the timeline: the span of the axis, the position of a tick, and the labels.
 * The span grows in steps, so that the ribbon does not move between them.
 */

/** Ticks in a second of simulated time. */
const SECOND = 60;
const MINUTE = 60 * SECOND;
const HOUR = 60 * MINUTE;

/** Spans of the axis in ticks. Beyond the last one, the span is a multiple of it. */
const SPANS: readonly number[] = [
  30 * SECOND,
  40 * SECOND,
  MINUTE,
  90 * SECOND,
  ...[2, 3, 4, 5, 10, 15, 20, 30, 45].map((minutes) => minutes * MINUTE),
  ...[1, 1.5, 2, 3, 4, 6, 8, 12].map((hours) => hours * HOUR),
];

/** Distances between two labels of the axis, in ticks. */
const STEPS: readonly number[] = [
  ...[1, 2, 5, 10, 15, 30].map((seconds) => seconds * SECOND),
  ...[1, 2, 3, 5, 10, 15, 30].map((minutes) => minutes * MINUTE),
  ...[1, 2, 3, 6, 12].map((hours) => hours * HOUR),
];

/** Minimum distance between two labels of the axis, in px. */
const LEAST_STEP_PX = 44;

type AxisUnit = "s" | "min" | "h";
const TICKS_OF_UNIT: Readonly<Record<AxisUnit | "tick", number>> = {
  tick: 1,
  s: SECOND,
  min: MINUTE,
  h: HOUR,
};

/** The displayed part of a run on a zoomed timeline. */
export interface TimeWindow {
  /** tick at the left end */
  from: number;
  /** ticks from the left end to the right end */
  span: number;
  /** ticks between two labels of the axis */
  step: number;
}

/** The mapping of ticks to a timeline of some width. */
export interface TimeScale {
  /** tick at the left end; 0 while the whole run is displayed */
  from: number;
  /** whether a part of the run is displayed; then the labels are clock times */
  isPart: boolean;
  /** ticks from the left end to the right end */
  span: number;
  /** ticks between two labels of the axis; divides the span */
  step: number;
  /** width in px */
  width: number;
}

/** A label of the axis. */
export interface AxisMark {
  tick: number;
  /** px from the left end */
  x: number;
  unit: AxisUnit | "tick";
  /** whole number of that unit */
  value: number;
}

/**
 * The scale on which a run of `endTick` ticks fits.
 * @param width width in px
 */
export function scaleOf(endTick: number, width: number): TimeScale {
  const widest = SPANS.at(-1) ?? HOUR;
  const span = SPANS.find((each) => each >= endTick) ?? Math.ceil(endTick / widest) * widest;
  const unit = TICKS_OF_UNIT[unitOf(span)];
  const isRoomy = (step: number) => (step / span) * width >= LEAST_STEP_PX;
  const step = STEPS.find((each) => each % unit === 0 && span % each === 0 && isRoomy(each));
  return { from: 0, isPart: false, span, step: step ?? span, width };
}

/** The position of a tick, in px from the left end, rounded to a tenth. */
export function xOf({ from, span, width }: TimeScale, tick: number): number {
  return Math.round(((tick - from) / span) * width * 10) / 10;
}

/** The tick at a position. Positions outside are clamped to the ends. */
export function tickAt({ from, span, width }: TimeScale, x: number): number {
  if (width <= 0) return from;
  return from + Math.round(Math.min(1, Math.max(0, x / width)) * span);
}

/** The labels of the axis from left to right, all in the same unit. */
export function axisOf(scale: TimeScale): AxisMark[] {
  const { from, span, step, isPart } = scale;
  const unit = isPart ? "tick" : unitOf(span);
  const first = Math.ceil(from / step) * step;
  return Array.from({ length: Math.floor((from + span - first) / step) + 1 }, (_, at) => {
    const tick = first + at * step;
    return { tick, x: xOf(scale, tick), unit, value: tick / TICKS_OF_UNIT[unit] };
  });
}

/** The unit in which the labels are whole numbers. */
function unitOf(span: number): AxisUnit {
  return span <= 2 * MINUTE ? "s" : span <= 2 * HOUR ? "min" : "h";
}
