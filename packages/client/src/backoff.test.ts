import fc from "fast-check";
import { expect, it } from "vitest";
import { RetryPauses } from "./backoff.ts";

const chance = fc.double({ min: 0, max: 1, maxExcluded: true, noNaN: true });
/** ms that a try takes to fail */
const tryMs = fc.integer({ min: 1, max: 50 });

/** When the first try after the net was back is made, in ms after it was back. */
function resumedAfter(awayMs: number, tries: Iterable<readonly [number, number]>): number {
  const pauses = new RetryPauses();
  let now = 0;
  for (const [drawn, ms] of tries) {
    now += pauses.next(now, drawn);
    if (now >= awayMs) break;
    // What is under way breaks at the latest when the net is back.
    now = Math.min(now + ms, awayMs);
  }
  return now - awayMs;
}

it("nobody is away for more than twice as long again as the net was, whatever is drawn", () => {
  fc.assert(
    fc.property(
      fc.integer({ min: 1, max: 4_000 }),
      fc.array(fc.tuple(chance, tryMs), { maxLength: 60 }),
      (awayMs, tries) => {
        expect(resumedAfter(awayMs, tries)).toBeLessThan(Math.max(250, 2 * awayMs) + 0.01);
      },
    ),
    { seed: 1 },
  );
});

it("those who lost the net in the same moment come back one by one", () => {
  const pauses = Array.from({ length: 5 }, (_none, n) => new RetryPauses().next(0, n / 5));
  expect(pauses).toEqual([0, 50, 100, 150, 200]);
});

it("pauses begin anew once all is well again", () => {
  const pauses = new RetryPauses();
  for (const now of [0, 1_000, 2_000, 4_000]) pauses.next(now, 0.5);
  pauses.beginAnew();
  expect(pauses.next(9_000, 0.5)).toBe(125);
});
