import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { FixedTimestep } from "./fixed-timestep.ts";

describe("FixedTimestep", () => {
  it("runs 60 ticks in a second at speed 1, however the second is cut", () => {
    fc.assert(
      fc.property(fc.array(fc.integer({ min: 1, max: 100 }), { minLength: 30 }), (cuts) => {
        const timestep = new FixedTimestep();
        const total = cuts.reduce((sum, each) => sum + each, 0);
        const ticks = cuts.reduce((sum, each) => sum + timestep.ticksFor(each, 1), 0);
        expect(Math.abs(ticks - (total * 60) / 1000)).toBeLessThan(1.001);
      }),
    );
  });

  it.each([
    { speed: 0.25, ticks: 3 },
    { speed: 1, ticks: 12 },
    { speed: 16, ticks: 192 },
  ])("gives $ticks ticks for 200 ms at speed $speed", ({ speed, ticks }) => {
    expect(new FixedTimestep().ticksFor(200.01, speed)).toBe(ticks);
  });

  it("does not catch up a sleep of an hour", () => {
    expect(new FixedTimestep().ticksFor(3_600_000, 1)).toBe(15);
  });

  it("forgets the part of a tick when time begins anew", () => {
    const timestep = new FixedTimestep();
    timestep.ticksFor(16, 1);
    timestep.clear();
    expect(timestep.ticksFor(16, 1)).toBe(0);
  });

  it.each([0.25, 1, 16])("begins with one tick at once at speed %s, and gains none", (speed) => {
    const timestep = new FixedTimestep();
    timestep.ticksFor(10, speed);
    timestep.start();
    expect(timestep.ticksFor(0, speed)).toBe(1);
    expect(timestep.ticksFor(0, speed)).toBe(0);
    expect(timestep.ticksFor(200.01, speed)).toBe(12 * speed - 1);
  });
});
