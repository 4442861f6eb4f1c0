/**
 * The robot's only playful motions: it recoils once from a bump and hops once on the goal. Both follow
 * the page's `--ease-nudge`, which swings a little over its end.
 */

/** Milliseconds, as `--dur-4`. */
const DURATION_MS = 420;
const RECOIL_PX = 6;
const HOP_PX = 8;

/** The curve's two handles: cubic-bezier(0.3, 1.6, 0.5, 1). */
const handles = { x1: 0.3, y1: 1.6, x2: 0.5, y2: 1 };
/** Halvings that find the curve's parameter within a thousandth. */
const HALVINGS = 10;

export interface Nudge {
  kind: "recoil" | "hop";
  /** unit vector that a recoil goes along, in the view; a hop goes up */
  dx: number;
  dy: number;
  /** monotonic milliseconds */
  startedAt: number;
}

/** Pixels by which the robot is drawn beside its place; null when the motion is over. */
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

/** `--ease-nudge`. @param share of the time, 0 to 1 */
export function easeNudge(share: number): number {
  const { x1, y1, x2, y2 } = handles;
  let low = 0;
  let high = 1;
  for (let halving = 0; halving < HALVINGS; halving++) {
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
