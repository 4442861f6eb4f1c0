import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { FixedTimestep } from "./fixed-timestep.ts";

describe("FixedTimestep", () => {
  it("runs 60 ticks per second at speed 1, for any lengths of the calls", () => {
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 1, max: 100 }), { minLength: 30 }), (intervals) => {
        const timestep = new FixedTimestep();
        const total = intervals.reduce((sum, each) => sum + each, 0);
        const ticks = intervals.reduce((sum, each) => sum + timestep.ticksFor(each, 1), 0);
        expect(Math.abs(ticks - (total * 60) / 1000)).toBeLessThan(1.001);
      }),
    );
  });

  it.each([
    { speed: 0.25, ticks: 3 },
    { speed: 1, ticks: 12 },
    { speed: 16, ticks: 192 },
  ])("returns $ticks ticks for 200 ms at speed $speed", ({ speed, ticks }) => {
    expect(new FixedTimestep().ticksFor(200.01, speed)).toBe(ticks);
  });

  it("does not catch up after an hour of sleep", () => {
    expect(new FixedTimestep().ticksFor(3_600_000, 1)).toBe(15);
  });

  it("discards the fraction of a tick on clear", () => {
    const timestep = new FixedTimestep();
    timestep.ticksFor(16, 1);
    timestep.clear();
    expect(timestep.ticksFor(16, 1)).toBe(0);
  });

  it.each([0.25, 1, 16])(
    "starts with one immediate tick at speed %s, and adds no tick",
    (speed) => {
      const timestep = new FixedTimestep();
      timestep.ticksFor(10, speed);
      timestep.start();
      expect(timestep.ticksFor(0, speed)).toBe(1);
      expect(timestep.ticksFor(0, speed)).toBe(0);
      expect(timestep.ticksFor(200.01, speed)).toBe(12 * speed - 1);
    },
  );
});
