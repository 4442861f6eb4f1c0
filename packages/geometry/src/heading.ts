/**
 * Headings: degrees clockwise from north (up), and the unit vectors that go with them.
 *
 * The engines of browsers and Node give different bits for `Math.sin` and `Math.cos`, so the vector
 * comes from the project's own polynomial: only + - * / and floor, the same bits everywhere.
 */

const RADIANS_PER_DEGREE = 0.017453292519943295;

/** The same direction in [0, 360). */
export function normaliseHeading(degrees: number): number {
  const rest = degrees % 360;
  const heading = rest < 0 ? rest + 360 : rest;
  // A tiny negative rest rounds up to 360 itself.
  return heading >= 360 ? 0 : heading;
}

/**
 * Writes the unit vector of a heading: x to the right, y downward.
 * Exact at quarter turns; elsewhere within 1e-15 of the true value.
 * @param heading degrees clockwise from north, in [0, 360)
 * @param out receives x at 0 and y at 1
 */
export function writeUnitVector(heading: number, out: Float64Array): void {
  const quarter = Math.floor((heading + 45) / 90);
  const r = (heading - quarter * 90) * RADIANS_PER_DEGREE;
  const q = r * r;
  // Taylor series; |r| <= pi/4, so the first term left out is below 5e-17.
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
