/** Snapshot rates over networks of all latencies, compared with a reader that acknowledges each. */
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { DelayedAcknowledgements } from "./delayed-acknowledgements.ts";
import {
  simulateReading,
  type NetworkPath,
  type Acknowledger,
  type ReadingLog,
} from "./testing/simulated-relay.ts";

const MINUTE = 60_000;
const each: Acknowledger = { reset: () => undefined, read: () => true };

const roundTrips = Array.from({ length: 60 }, (_, at) => 5 * (at + 1));
/** Report intervals: by frames of a screen, by drifting timers, and long ones. */
const intervals = [1000 / 60, 1000 / 30, 49.9, 50, 50.3, 1000 / 15, 75, 100, 250];
/** Alternating intervals, as after a snapshot for which the relay waited. */
const alternating = [
  [33, 67],
  [67, 33],
  [50, 67],
  [67, 50],
  [40, 60],
  [60, 40],
  [16, 84],
];

/** Both readers over the same network. */
function both(path: () => NetworkPath, ms: number): { delayed: ReadingLog; each: ReadingLog } {
  return {
    delayed: simulateReading(path(), new DelayedAcknowledgements(), ms),
    each: simulateReading(path(), each, ms),
  };
}

function lossOf(
  { delayed, each: all }: { delayed: ReadingLog; each: ReadingLog },
  from = 0,
): number {
  return 1 - countSince(delayed.read, from) / countSince(all.read, from);
}

/** The share of acknowledged snapshots. */
function acknowledgedShare({ read, acknowledged }: ReadingLog, from = 0): number {
  return countSince(acknowledged, from) / countSince(read, from);
}

function countSince(times: readonly number[], from: number): number {
  return times.filter((time) => time >= from).length;
}

/** Seeded random delays from 0 to `max` ms. */
function jitter(max: number, seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return (max * state) / 2 ** 32;
  };
}

describe("a reader that does not acknowledge each snapshot", () => {
  it.each([
    ...intervals.map((pageMs) => ({ pageMs })),
    ...alternating.map((pageMs) => ({ pageMs })),
  ])("loses no snapshots in a minute of a page that reports every $pageMs ms", ({ pageMs }) => {
    for (const ms of [...roundTrips, 51, 52, 53, 54, 56, 57, 58, 59, 76]) {
      const logs = both(() => ({ pageMs, roundTripMs: () => ms }), MINUTE);
      expect(lossOf(logs), `round trip of ${ms} ms`).toBeLessThanOrEqual(0.01);
    }
  });

  it("loses none with jitter", () => {
    const paths = fc.record({
      pageMs: fc.double({ min: 15, max: 120, noNaN: true }),
      ms: fc.double({ min: 5, max: 300, noNaN: true }),
      max: fc.double({ min: 0, max: 25, noNaN: true }),
      seed: fc.nat(),
    });
    fc.assert(
      fc.property(paths, ({ pageMs, ms, max, seed }) => {
        const logs = both(
          () => ({ pageMs, roundTripMs: () => ms, jitterMs: jitter(max, seed) }),
          MINUTE,
        );
        expect(lossOf(logs)).toBeLessThanOrEqual(0.01);
      }),
      { numRuns: 150 },
    );
  });

  it.each([0, 3, 6])(
    "acknowledges little more than half of them over a fast network with %i ms of jitter",
    (max) => {
      for (const pageMs of [1000 / 30, 50, 1000 / 15]) {
        for (const ms of [5, 20, 40]) {
          const path = { pageMs, roundTripMs: () => ms, jitterMs: jitter(max, 7) };
          expect(
            acknowledgedShare(simulateReading(path, new DelayedAcknowledgements(), MINUTE)),
          ).toBeLessThan(0.51);
        }
      }
    },
  );

  it.each([76, 120])("adapts when the round trip rises to %i ms and falls again", (ms) => {
    const roundTripMs = (now: number): number => (now >= MINUTE && now < 2 * MINUTE ? ms : 20);
    const logs = both(() => ({ pageMs: 1000 / 30, roundTripMs }), 4 * MINUTE);
    expect(lossOf(logs)).toBeLessThanOrEqual(0.01);
    const duringRise = (times: number[]): number =>
      countSince(times, MINUTE) - countSince(times, 2 * MINUTE);
    expect(duringRise(logs.delayed.read)).toBeGreaterThanOrEqual(0.99 * duringRise(logs.each.read));
    expect(acknowledgedShare(logs.delayed, 3 * MINUTE)).toBeLessThan(0.51);
  });
});
