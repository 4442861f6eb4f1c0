import { describe, expect, it } from "vitest";
import { TrailFeed } from "./trail-feed.ts";

const HOUR = 216_000;
/** The largest number of corners in the trail. */
const RETAINED = 20_000;

/** Positions of a robot that turned and bumped at the end of every tick. */
const places = {
  countUpTo: (tick: number) => tick,
  slice: (from: number, to: number) =>
    Array.from({ length: to - from }, (_, at) => [from + at + 1, 50]).flat(),
};
const log = { corners: places, bumps: places };

describe("TrailFeed", () => {
  it("sends only the new part on the way forward", () => {
    const feed = new TrailFeed();
    feed.take(log, 100);
    const { corners, bumps, trailReset } = feed.take(log, 102);
    expect(corners).toEqual([101, 50, 102, 50]);
    expect(bumps).toEqual([101, 50, 102, 50]);
    expect(trailReset).toBe(false);
  });

  it("sends no more after a jump forward over most of an hour than after one back: the drawn part", () => {
    const feed = new TrailFeed();
    feed.take(log, 100);
    const forward = feed.take(log, HOUR);
    expect(forward.corners).toHaveLength(2 * RETAINED);
    expect(forward.corners.slice(-2)).toEqual([HOUR, 50]);
    // A line across the gap would be a path that the robot never drove.
    expect(forward.trailReset).toBe(true);
    feed.take(log, HOUR - 1);
    feed.take(log, HOUR + 1);
    expect(feed.take(log, HOUR)).toEqual(forward);
  });
});
