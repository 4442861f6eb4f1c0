/**
 * The robot's only playful animations: a recoil from a bump and a hop on the goal. Both use the
 * page's `--ease-nudge`, which overshoots slightly.
 */

/** Milliseconds, the same as `--dur-4`. */
const DURATION_MS = 420;
const RECOIL_PX = 6;
const HOP_PX = 8;

/** Control points of the curve: cubic-bezier(0.3, 1.6, 0.5, 1). */
const handles = { x1: 0.3, y1: 1.6, x2: 0.5, y2: 1 };
/** Bisections that find the curve's parameter within a thousandth. */
const BISECTIONS = 10;

export interface Nudge {
  kind: "recoil" | "hop";
  /** unit vector of a recoil, in the view; a hop goes up */
  dx: number;
  dy: number;
  /** monotonic milliseconds */
  startedAt: number;
}

/** Offset in pixels of the robot from its position; null once the animation is over. */
export function nudgeOffset(
  { kind, dx, dy, startedAt }: Nudge,
  now: number,
): { x: number; y: number } | null {
  const share = (now - startedAt) / DURATION_MS;
  if (share < 0 || share >= 1) return null;
  if (kind === "recoil") {
    const pixels = RECOIL_PX * (1 - easeNudge(share));
    return { x: dx * pixels, y: dy * pixels };
  }
  const height = share < 0.5 ? easeNudge(2 * share) : 1 - easeNudge(2 * share - 1);
  return { x: 0, y: -HOP_PX * height };
}

/**
 * Value of `--ease-nudge`.
 * @param share elapsed share of the duration, 0 to 1
 */
export function easeNudge(share: number): number {
  const { x1, y1, x2, y2 } = handles;
  let low = 0;
  let high = 1;
  for (let step = 0; step < BISECTIONS; step++) {
    const middle = (low + high) / 2;
    if (bezier(middle, x1, x2) < share) low = middle;
    else high = middle;
  }
  return share >= 1 ? 1 : bezier(low, y1, y2);
}

function bezier(at: number, first: number, second: number): number {
  const rest = 1 - at;
  return 3 * rest * rest * at * first + 3 * rest * at * at * second + at * at * at;
}
