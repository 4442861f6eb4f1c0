/**
 * The displayed part of a run on a zoomed timeline: how it grows, shrinks, moves and follows a
 * tick.
 */
import { scaleOf, type TimeWindow } from "./time-scale.ts";

/** The shortest part, in ticks: two seconds. */
const LEAST_SPAN = 120;
/** Distances between two labels of the axis, in ticks; below one second the labels have tenths. */
const STEPS: readonly number[] = [
  12, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 18_000, 36_000, 54_000, 108_000, 216_000,
];
/** Minimum distance between two labels in px, for "104:30.5". */
const LEAST_STEP_PX = 56;
/**
 * Position of a followed tick that leaves the part on the right, as a share of the part; mirrored
 * on the left.
 */
const AHEAD = 0.75;

/** The state of a timeline that can be zoomed. */
export interface Zoomed {
  /** null while the whole run is displayed */
  window: TimeWindow | null;
  /** the last tick of the run */
  endTick: number;
  /** width in px */
  width: number;
}

/**
 * The part after a zoom.
 * @param factor above 1 zooms in
 * @param at the tick that stays in place
 * @param share its position, from 0 (left end) to 1
 * @returns null if the whole run fits
 */
export function zoomedBy(
  { window, endTick, width }: Zoomed,
  factor: number,
  at: number,
  share: number,
): TimeWindow | null {
  const whole = scaleOf(endTick, width).span;
  const span = Math.max(LEAST_SPAN, (window?.span ?? whole) / factor);
  return span >= whole ? null : windowOf(at - share * span, span, whole, width);
}

/** The part that starts at another tick. */
export function movedTo({ window, endTick, width }: Zoomed, from: number): TimeWindow | null {
  if (window === null) return null;
  return windowOf(from, window.span, scaleOf(endTick, width).span, width);
}

/** The part that contains a tick; unchanged if it already does. */
export function following(zoomed: Zoomed, tick: number): TimeWindow | null {
  const { window } = zoomed;
  if (window === null || holds(window, tick)) return window;
  const share = tick > window.from ? AHEAD : 1 - AHEAD;
  return movedTo(zoomed, tick - share * window.span);
}

export function holds({ from, span }: TimeWindow, tick: number): boolean {
  return tick >= from && tick <= from + span;
}

function windowOf(from: number, span: number, whole: number, width: number): TimeWindow {
  const step = STEPS.find((each) => (each / span) * width >= LEAST_STEP_PX) ?? span;
  return { from: Math.round(Math.min(Math.max(0, from), whole - span)), span, step };
}
