import { Timeline, type TimelineDriver } from "@corridor/recording";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { ribbonOf } from "./ribbon.ts";
import { scaleOf } from "./time-scale.ts";

const width = 480;

/** A run of stretches, each with its length in ticks. */
function runOf(...stretches: [Exclude<TimelineDriver, "mixed">, number][]): Timeline {
  const timeline = new Timeline();
  let tick = 0;
  for (const [who, length] of stretches) {
    timeline.recordDriver(tick, who);
    tick += length;
    timeline.advanceTo(tick);
  }
  return timeline;
}

function segmentsOf(timeline: Timeline) {
  return ribbonOf(timeline, scaleOf(timeline.endTick, width));
}

describe("the ribbon", () => {
  it("shows who drove for how long, and which segment is the newest", () => {
    const segments = segmentsOf(runOf(["me", 225], [1, 75], ["default", 150], ["remote", 450]));
    expect(segments).toEqual([
      { who: "me", x: 0, width: 59, isNewest: false },
      { who: 1, x: 60, width: 19, isNewest: false },
      { who: "default", x: 80, width: 39, isNewest: false },
      { who: "remote", x: 120, width: 119, isNewest: true },
    ]);
  });

  it("is empty before a run", () => {
    expect(segmentsOf(new Timeline())).toEqual([]);
  });

  it("shows fast changes as one mixed segment, and the current driver beside it", () => {
    const chatter = Array.from({ length: 60 }, (_, at): [number, number] => [at % 2, 8]);
    const segments = segmentsOf(runOf([4, 600], ...chatter, [2, 300]));
    expect(segments.map(({ who }) => who)).toEqual([4, "mixed", 2]);
  });

  it("shows changes finer than a pixel as one mixed segment, too", () => {
    const chatter = Array.from({ length: 600 }, (_, at): [number, number] => [at % 2, 7]);
    const segments = segmentsOf(runOf([4, 60_000], ...chatter, [2, 30_000]));
    expect(segments.map(({ who }) => who)).toEqual([4, "mixed", 2]);
  });

  it("shows one short segment between long ones", () => {
    const segments = segmentsOf(runOf([0, 600], [1, 7], [0, 600]));
    expect(segments.map(({ who }) => who)).toEqual([0, 1, 0]);
  });

  it("of any run lies within the screen, in order, without overlaps, in few pieces", () => {
    const anyWho = fc.oneof(
      fc.constantFrom("me" as const, "remote" as const, "default" as const),
      fc.integer({ min: 0, max: 5 }),
    );
    const anyStretches = fc.array(fc.tuple(anyWho, fc.integer({ min: 1, max: 900 })), {
      maxLength: 400,
      size: "max",
    });
    fc.assert(
      fc.property(anyStretches, (stretches) => {
        const timeline = runOf(...stretches);
        const segments = segmentsOf(timeline);
        let right = 0;
        let overlap = 0;
        for (const { x, width: wide } of segments) {
          overlap = Math.max(overlap, right - x);
          right = x + wide;
        }
        // The narrowest segment is one pixel wide, and positions are rounded to a tenth of a pixel.
        expect(overlap).toBeLessThan(1.1);
        expect(Math.min(1, ...segments.map((segment) => segment.width))).toBe(1);
        expect(right).toBeLessThanOrEqual(width + 1);
        expect(segments.length).toBeLessThanOrEqual((2 * width) / 3 + 2);
        expect(segments.filter(({ isNewest }) => isNewest)).toHaveLength(
          Math.min(1, timeline.segmentCount),
        );
        const last = timeline.segmentCount - 1;
        expect(segments.at(-1)?.who).toBe(last < 0 ? undefined : timeline.driverOf(last));
      }),
    );
  });

  it("does not visit every segment of an hours-long run", () => {
    const timeline = runOf(
      ...Array.from({ length: 30_000 }, (_, at): [number, number] => [at % 2, 8]),
    );
    let reads = 0;
    ribbonOf(
      {
        segmentCount: timeline.segmentCount,
        endTick: timeline.endTick,
        segmentAt: (tick) => timeline.segmentAt(tick),
        driverOf: (index) => timeline.driverOf(index),
        tickOf: (index) => {
          reads += 1;
          return timeline.tickOf(index);
        },
      },
      scaleOf(timeline.endTick, width),
    );
    expect(reads).toBeLessThan(2 * width);
  });
});
