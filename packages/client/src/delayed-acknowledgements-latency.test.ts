/** How many snapshots come over lines of all lengths, beside a reader that says `seen` for each. */
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { SeenPace } from "./delayed-acknowledgements.ts";
import { pacedLine, type PacedLine, type PacedReader, type Told } from "./testing/simulated-relay.ts";

const MINUTE = 60_000;
const each: PacedReader = { begin: () => undefined, read: () => true };

const lengths = Array.from({ length: 60 }, (_, at) => 5 * (at + 1));
/** By the frames of a screen, by timers that drift, and seldom. */
const pages = [1000 / 60, 1000 / 30, 49.9, 50, 50.3, 1000 / 15, 75, 100, 250];
/** Pauses that alternate, as after a snapshot that the relay waited for. */
const unevenPages = [
  [33, 67],
  [67, 33],
  [50, 67],
  [67, 50],
  [40, 60],
  [60, 40],
  [16, 84],
];

/** Both over a line of the same behaviour. */
function both(line: () => PacedLine, ms: number): { pace: Told; each: Told } {
  return { pace: pacedLine(line(), new SeenPace(), ms), each: pacedLine(line(), each, ms) };
}

function lostOf({ pace, each: all }: { pace: Told; each: Told }, from = 0): number {
  return 1 - countSince(pace.read, from) / countSince(all.read, from);
}

/** How many of the snapshots are said. */
function saidOf({ read, said }: Told, from = 0): number {
  return countSince(said, from) / countSince(read, from);
}

function countSince(times: readonly number[], from: number): number {
  return times.filter((time) => time >= from).length;
}

/** Lateness from 0 to so many ms, the same for the same seed. */
function jitter(most: number, seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1_664_525) + 1_013_904_223) >>> 0;
    return (most * state) / 2 ** 32;
  };
}

describe("a reader that does not say each", () => {
  it.each([...pages.map((pageMs) => ({ pageMs })), ...unevenPages.map((pageMs) => ({ pageMs }))])(
    "loses no snapshots in a minute of a page that reports each $pageMs ms",
    ({ pageMs }) => {
      for (const ms of [...lengths, 51, 52, 53, 54, 56, 57, 58, 59, 76]) {
        const told = both(() => ({ pageMs, roundTripMs: () => ms }), MINUTE);
        expect(lostOf(told), `over ${ms} ms there and back`).toBeLessThanOrEqual(0.01);
      }
    },
  );

  it("loses none over lines that are uneven", () => {
    const line = fc.record({
      pageMs: fc.double({ min: 15, max: 120, noNaN: true }),
      ms: fc.double({ min: 5, max: 300, noNaN: true }),
      most: fc.double({ min: 0, max: 25, noNaN: true }),
      seed: fc.nat(),
    });
    fc.assert(
      fc.property(line, ({ pageMs, ms, most, seed }) => {
        const told = both(
          () => ({ pageMs, roundTripMs: () => ms, jitterMs: jitter(most, seed) }),
          MINUTE,
        );
        expect(lostOf(told)).toBeLessThanOrEqual(0.01);
      }),
      { numRuns: 150 },
    );
  });

  it.each([0, 3, 6])(
    "says little more than half of them over a short line, %i ms uneven",
    (most) => {
      for (const pageMs of [1000 / 30, 50, 1000 / 15]) {
        for (const ms of [5, 20, 40]) {
          const line = { pageMs, roundTripMs: () => ms, jitterMs: jitter(most, 7) };
          expect(saidOf(pacedLine(line, new SeenPace(), MINUTE))).toBeLessThan(0.51);
        }
      }
    },
  );

  it.each([76, 120])("notices that its line takes %i ms now, and that it is short again", (ms) => {
    const roundTripMs = (now: number): number => (now >= MINUTE && now < 2 * MINUTE ? ms : 20);
    const told = both(() => ({ pageMs: 1000 / 30, roundTripMs }), 4 * MINUTE);
    expect(lostOf(told)).toBeLessThanOrEqual(0.01);
    const long = (times: number[]): number =>
      countSince(times, MINUTE) - countSince(times, 2 * MINUTE);
    expect(long(told.pace.read)).toBeGreaterThanOrEqual(0.99 * long(told.each.read));
    expect(saidOf(told.pace, 3 * MINUTE)).toBeLessThan(0.51);
  });
});
