/**
 * A heading between two others, turned the shorter way: 0 lies between 350 and 10.
 * @param from @param to degrees in [0, 360)
 * @param share of the turn, from 0 to 1
 * @returns degrees in [0, 360)
 */
export function blendHeading(from: number, to: number, share: number): number {
  const way = ((to - from + 540) % 360) - 180;
  return (from + way * share + 360) % 360;
}
