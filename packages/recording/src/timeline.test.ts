import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { Timeline, type TimelineDriver } from "./timeline.ts";

function stretchesOf(timeline: Timeline): [number, TimelineDriver][] {
  return Array.from({ length: timeline.segmentCount }, (_, index) => [
    timeline.tickOf(index),
    timeline.driverOf(index),
  ]);
}

function eventsOf(timeline: Timeline) {
  return Array.from({ length: timeline.eventCount }, (_, index) => timeline.eventAt(index));
}

function timelineOf(...stretches: [number, Exclude<TimelineDriver, "mixed">][]): Timeline {
  const timeline = new Timeline();
  for (const [tick, who] of stretches) timeline.recordDriver(tick, who);
  return timeline;
}

describe("who drove", () => {
  it("is one stretch while the same line decides", () => {
    expect(stretchesOf(timelineOf([0, "default"], [50, "default"], [60, 2], [99, 2]))).toEqual([
      [0, "default"],
      [60, 2],
    ]);
  });

  it("is mixed where it changes faster than can be told, and named again after it", () => {
    const timeline = timelineOf([0, "me"], [100, 0], [101, 1], [102, 0], [104, 1], [106, 0]);
    timeline.recordDriver(200, "remote");
    expect(stretchesOf(timeline)).toEqual([
      [0, "me"],
      [100, "mixed"],
      [106, 0],
      [200, "remote"],
    ]);
  });

  it("names a short stretch between long ones", () => {
    expect(stretchesOf(timelineOf([0, 0], [50, 1], [51, 0], [90, 1]))).toEqual([
      [0, 0],
      [50, 1],
      [51, 0],
      [90, 1],
    ]);
  });

  it("is found by tick", () => {
    const timeline = timelineOf([10, 0], [60, 1]);
    expect([9, 10, 59, 60, 1000].map((tick) => timeline.segmentAt(tick))).toEqual([-1, 0, 0, 1, 1]);
  });
});

describe("what happened", () => {
  it("is one mark where it happens again and again, and separate by kind and driver", () => {
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

  it("after a tick is forgotten with it, and so is the turn that began there", () => {
    const timeline = timelineOf([0, 0], [50, 1], [80, 2]);
    timeline.recordEvent({ kind: "bump", tick: 50, driver: 0 });
    timeline.recordEvent({ kind: "turn", turn: "left 90", tick: 50, driver: 1 });
    timeline.recordEvent({ kind: "goal", tick: 70, driver: 1 });
    timeline.truncateAfter(50);
    expect(stretchesOf(timeline)).toEqual([[0, 0]]);
    expect(eventsOf(timeline)).toEqual([{ kind: "bump", tick: 50, driver: 0 }]);
    expect(timeline.endTick).toBe(50);
  });
});

it("a page is told of what is forgotten where the run ends at the tick that it knows", () => {
  const worker = timelineOf([6, "me"]);
  const page = new Timeline();
  worker.advanceTo(6);
  const known = worker.takeDelta();
  if (known !== null) page.applyDelta(known);
  worker.truncateAfter(6);
  const delta = worker.takeDelta();
  if (delta !== null) page.applyDelta(delta);
  expect(stretchesOf(page)).toEqual(stretchesOf(worker));
});

it("a page that takes the delta in, however seldom, has the worker's timeline", () => {
  const who = fc.constantFrom<Exclude<TimelineDriver, "mixed">>("me", "remote", "default", 0, 1, 2);
  fc.assert(
    fc.property(
      fc.array(
        fc.record({
          who,
          ticks: fc.oneof(fc.integer({ min: 0, max: 5 }), fc.integer({ min: 6, max: 60 })),
          deed: fc.constantFrom("drives", "drives", "bump", "take", "forget"),
        }),
        { maxLength: 80 },
      ),
      (deeds) => {
        const worker = new Timeline();
        const page = new Timeline();
        let tick = 0;
        for (const each of deeds) {
          tick += each.ticks;
          if (each.deed === "drives") worker.recordDriver(tick, each.who);
          if (each.deed === "bump") worker.recordEvent({ kind: "bump", tick, driver: each.who });
          if (each.deed === "forget") {
            tick = Math.floor(tick / 2);
            worker.truncateAfter(tick);
          }
          worker.advanceTo(tick);
          if (each.deed !== "take") continue;
          const delta = worker.takeDelta();
          if (delta !== null) page.applyDelta(structuredClone(delta));
        }
        const rest = worker.takeDelta();
        if (rest !== null) page.applyDelta(rest);
        expect(worker.takeDelta()).toBeNull();
        expect(stretchesOf(page)).toEqual(stretchesOf(worker));
        expect(eventsOf(page)).toEqual(eventsOf(worker));
        expect(page.endTick).toBe(worker.endTick);
        const ticks = stretchesOf(page).map(([from]) => from);
        expect(ticks).toEqual([...new Set(ticks)].toSorted((a, b) => a - b));
      },
    ),
    { numRuns: 300 },
  );
});

it("a timeline of far too many changes keeps a bounded number, and still the whole time", () => {
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

it("a file of very many edits has a bounded number of marks, from the first edit to the last", () => {
  const timeline = new Timeline();
  for (let tick = 0; tick < 100_000; tick++) {
    timeline.recordEvent({ kind: "edit", what: "program", tick, driver: 0 });
  }
  expect(timeline.eventCount).toBeLessThanOrEqual(50_000);
  expect(timeline.eventCount).toBeGreaterThan(5_000);
  expect(timeline.eventAt(0).tick).toBe(0);
  expect(timeline.eventAt(timeline.eventCount - 1).tick).toBeGreaterThan(99_900);
});
