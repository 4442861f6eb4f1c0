import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { Timeline, type TimelineDriver } from "./timeline.ts";

function segmentsOf(timeline: Timeline): [number, TimelineDriver][] {
  return Array.from({ length: timeline.segmentCount }, (_, index) => [
    timeline.tickOf(index),
    timeline.driverOf(index),
  ]);
}

function eventsOf(timeline: Timeline) {
  return Array.from({ length: timeline.eventCount }, (_, index) => timeline.eventAt(index));
}

function timelineOf(...segments: [number, Exclude<TimelineDriver, "mixed">][]): Timeline {
  const timeline = new Timeline();
  for (const [tick, driver] of segments) timeline.recordDriver(tick, driver);
  return timeline;
}

describe("segments", () => {
  it("merge while the same line decides", () => {
    expect(segmentsOf(timelineOf([0, "default"], [50, "default"], [60, 2], [99, 2]))).toEqual([
      [0, "default"],
      [60, 2],
    ]);
  });

  it("are mixed during fast changes, and have a driver again after them", () => {
    const timeline = timelineOf([0, "me"], [100, 0], [101, 1], [102, 0], [104, 1], [106, 0]);
    timeline.recordDriver(200, "remote");
    expect(segmentsOf(timeline)).toEqual([
      [0, "me"],
      [100, "mixed"],
      [106, 0],
      [200, "remote"],
    ]);
  });

  it("include a short segment between long ones", () => {
    expect(segmentsOf(timelineOf([0, 0], [50, 1], [51, 0], [90, 1]))).toEqual([
      [0, 0],
      [50, 1],
      [51, 0],
      [90, 1],
    ]);
  });

  it("are found by tick", () => {
    const timeline = timelineOf([10, 0], [60, 1]);
    expect([9, 10, 59, 60, 1000].map((tick) => timeline.segmentAt(tick))).toEqual([-1, 0, 0, 1, 1]);
  });
});

describe("events", () => {
  it("merge within the minimum gap, separately for each kind and driver", () => {
    const timeline = new Timeline();
    for (const tick of [100, 101, 103]) timeline.recordEvent({ kind: "bump", tick, driver: 0 });
    timeline.recordEvent({ kind: "bump", tick: 103, driver: 1 });
    timeline.recordEvent({ kind: "goal", tick: 103, driver: 1 });
    timeline.recordEvent({ kind: "turn", turn: "delayed left 90", tick: 103, driver: 1 });
    timeline.recordEvent({ kind: "bump", tick: 110, driver: 0 });
    timeline.recordEvent({ kind: "edit", what: "program", tick: 110, driver: 0 });
    timeline.recordEvent({ kind: "edit", what: "maze", tick: 111, driver: 0 });
    expect(eventsOf(timeline)).toEqual([
      { kind: "bump", tick: 100, driver: 0 },
      { kind: "bump", tick: 103, driver: 1 },
      { kind: "goal", tick: 103, driver: 1 },
      { kind: "turn", turn: "delayed left 90", tick: 103, driver: 1 },
      { kind: "bump", tick: 110, driver: 0 },
      { kind: "edit", what: "program", tick: 110, driver: 0 },
      { kind: "edit", what: "maze", tick: 111, driver: 0 },
    ]);
    expect(timeline.eventsUpTo(103)).toBe(4);
  });

  it("after a tick are deleted by truncateAfter, together with a turn at that tick", () => {
    const timeline = timelineOf([0, 0], [50, 1], [80, 2]);
    timeline.recordEvent({ kind: "bump", tick: 50, driver: 0 });
    timeline.recordEvent({ kind: "turn", turn: "left 90", tick: 50, driver: 1 });
    timeline.recordEvent({ kind: "goal", tick: 70, driver: 1 });
    timeline.truncateAfter(50);
    expect(segmentsOf(timeline)).toEqual([[0, 0]]);
    expect(eventsOf(timeline)).toEqual([{ kind: "bump", tick: 50, driver: 0 }]);
    expect(timeline.endTick).toBe(50);
  });
});

it("a delta contains a truncation at the end tick of the previous delta", () => {
  const worker = timelineOf([6, "me"]);
  const page = new Timeline();
  worker.advanceTo(6);
  const first = worker.takeDelta();
  if (first !== null) page.applyDelta(first);
  worker.truncateAfter(6);
  const delta = worker.takeDelta();
  if (delta !== null) page.applyDelta(delta);
  expect(segmentsOf(page)).toEqual(segmentsOf(worker));
});

it("a page that applies all deltas, at any intervals, has the worker's timeline", () => {
  const driver = fc.constantFrom<Exclude<TimelineDriver, "mixed">>(
    "me",
    "remote",
    "default",
    0,
    1,
    2,
  );
  fc.assert(
    fc.property(
      fc.array(
        fc.record({
          driver,
          ticks: fc.oneof(fc.integer({ min: 0, max: 5 }), fc.integer({ min: 6, max: 60 })),
          kind: fc.constantFrom("driver", "driver", "bump", "delta", "truncate"),
        }),
        { maxLength: 80 },
      ),
      (operations) => {
        const worker = new Timeline();
        const page = new Timeline();
        let tick = 0;
        for (const each of operations) {
          tick += each.ticks;
          if (each.kind === "driver") worker.recordDriver(tick, each.driver);
          if (each.kind === "bump") worker.recordEvent({ kind: "bump", tick, driver: each.driver });
          if (each.kind === "truncate") {
            tick = Math.floor(tick / 2);
            worker.truncateAfter(tick);
          }
          worker.advanceTo(tick);
          if (each.kind !== "delta") continue;
          const delta = worker.takeDelta();
          if (delta !== null) page.applyDelta(structuredClone(delta));
        }
        const rest = worker.takeDelta();
        if (rest !== null) page.applyDelta(rest);
        expect(worker.takeDelta()).toBeNull();
        expect(segmentsOf(page)).toEqual(segmentsOf(worker));
        expect(eventsOf(page)).toEqual(eventsOf(worker));
        expect(page.endTick).toBe(worker.endTick);
        const ticks = segmentsOf(page).map(([from]) => from);
        expect(ticks).toEqual([...new Set(ticks)].toSorted((a, b) => a - b));
      },
    ),
    { numRuns: 300 },
  );
});

it("a timeline with too many changes has a bounded number of entries over the whole time", () => {
  const timeline = new Timeline();
  for (let tick = 0; tick < 1_200_000; tick += 8) {
    timeline.recordDriver(tick, tick % 16 === 0 ? 0 : 1);
    timeline.recordEvent({ kind: "bump", tick, driver: 0 });
  }
  expect(timeline.segmentCount).toBeLessThanOrEqual(50_000);
  expect(timeline.eventCount).toBeLessThanOrEqual(50_000);
  expect(timeline.eventCount).toBeGreaterThan(10_000);
  expect(timeline.tickOf(0)).toBe(0);
});

it("a timeline with 100,000 edits has a bounded number of events, from the first edit to the last", () => {
  const timeline = new Timeline();
  for (let tick = 0; tick < 100_000; tick++) {
    timeline.recordEvent({ kind: "edit", what: "program", tick, driver: 0 });
  }
  expect(timeline.eventCount).toBeLessThanOrEqual(50_000);
  expect(timeline.eventCount).toBeGreaterThan(5_000);
  expect(timeline.eventAt(0).tick).toBe(0);
  expect(timeline.eventAt(timeline.eventCount - 1).tick).toBeGreaterThan(99_900);
});
