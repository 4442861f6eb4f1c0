import fc from "fast-check";
import { expect, it } from "vitest";
import { Backoff } from "./backoff.ts";

const random = fc.double({ min: 0, max: 1, maxExcluded: true, noNaN: true });
/** ms until an attempt fails */
const attemptMs = fc.integer({ min: 1, max: 50 });

/** ms from the end of an outage to the first attempt after it. */
function resumedAfter(outageMs: number, attempts: Iterable<readonly [number, number]>): number {
  const backoff = new Backoff();
  let now = 0;
  for (const [drawn, ms] of attempts) {
    now += backoff.next(now, drawn);
    if (now >= outageMs) break;
    // A pending attempt fails at the latest when the network is back.
    now = Math.min(now + ms, outageMs);
  }
  return now - outageMs;
}

it("clients reconnect within twice the length of the outage, for any random numbers", () => {
  fc.assert(
    fc.property(
      fc.integer({ min: 1, max: 4_000 }),
      fc.array(fc.tuple(random, attemptMs), { maxLength: 60 }),
      (outageMs, attempts) => {
        expect(resumedAfter(outageMs, attempts)).toBeLessThan(Math.max(250, 2 * outageMs) + 0.01);
      },
    ),
    { seed: 1 },
  );
});

it("clients that disconnect at the same moment reconnect at different ones", () => {
  const delays = Array.from({ length: 5 }, (_none, n) => new Backoff().next(0, n / 5));
  expect(delays).toEqual([0, 50, 100, 150, 200]);
});

it("delays start over after a success", () => {
  const backoff = new Backoff();
  for (const now of [0, 1_000, 2_000, 4_000]) backoff.next(now, 0.5);
  backoff.reset();
  expect(backoff.next(9_000, 0.5)).toBe(125);
});
