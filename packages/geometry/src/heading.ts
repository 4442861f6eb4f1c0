/**
 * Headings, in degrees clockwise from north (up), and their unit vectors.
 *
 * JavaScript engines return different bits for `Math.sin` and `Math.cos`. This module therefore
 * evaluates its own polynomial with + - * / and floor only, which are exact to the bit everywhere.
 */

const RADIANS_PER_DEGREE = 0.017453292519943295;

/** Returns the same direction in [0, 360) degrees. */
export function normaliseHeading(degrees: number): number {
  const remainder = degrees % 360;
  const heading = remainder < 0 ? remainder + 360 : remainder;
  // A tiny negative remainder plus 360 rounds to 360 itself.
  return heading >= 360 ? 0 : heading;
}

/**
 * Writes the unit vector of a heading. x points right, y points down.
 * The result is exact at quarter turns and within 1e-15 of the true value elsewhere.
 * @param heading degrees clockwise from north, in [0, 360)
 * @param out receives x at 0 and y at 1
 */
export function writeUnitVector(heading: number, out: Float64Array): void {
  const quarter = Math.floor((heading + 45) / 90);
  const r = (heading - quarter * 90) * RADIANS_PER_DEGREE;
  const q = r * r;
  // Taylor series. Since |r| <= pi/4, the first omitted term is below 5e-17.
  const sin =
    r *
    (1 +
      q *
        (-1 / 6 +
          q *
            (1 / 120 +
              q *
                (-1 / 5040 +
                  q *
                    (1 / 362880 +
                      q * (-1 / 39916800 + q * (1 / 6227020800 + q * (-1 / 1307674368000))))))));
  const cos =
    1 +
    q *
      (-1 / 2 +
        q *
          (1 / 24 +
            q *
              (-1 / 720 +
                q *
                  (1 / 40320 +
                    q *
                      (-1 / 3628800 +
                        q * (1 / 479001600 + q * (-1 / 87178291200 + q / 20922789888000)))))));
  switch (quarter & 3) {
    case 0:
      out[0] = sin;
      out[1] = -cos;
      return;
    case 1:
      out[0] = cos;
      out[1] = sin;
      return;
    case 2:
      out[0] = -sin;
      out[1] = cos;
      return;
    default:
      out[0] = -cos;
      out[1] = -sin;
  }
}
