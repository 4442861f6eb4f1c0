/** One notch of a wheel, 100 pixels, zooms by a quarter. */
const PER_PIXEL = Math.log(1.25) / 100;
/** Maximum of one event: a trackpad's pinch sends small deltas, a wheel large ones. */
const MAX_DELTA = 100;

/** @returns the zoom factor of an event; above 1 enlarges */
export function wheelZoom({ deltaY }: WheelEvent): number {
  return Math.exp(-Math.max(-MAX_DELTA, Math.min(MAX_DELTA, deltaY)) * PER_PIXEL);
}
