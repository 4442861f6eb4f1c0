import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { axisOf, scaleOf, tickAt, xOf } from "./time-scale.ts";

const width = 476;
const seconds = (count: number) => count * 60;

describe("the axis of the timeline", () => {
  it.each([
    { run: 0, names: "0 5 10 15 20 25 30", unit: "s" },
    { run: 17.7, names: "0 5 10 15 20 25 30", unit: "s" },
    { run: 39.2, names: "0 5 10 15 20 25 30 35 40", unit: "s" },
    { run: 41, names: "0 10 20 30 40 50 60", unit: "s" },
    { run: 61, names: "0 10 20 30 40 50 60 70 80 90", unit: "s" },
    { run: 100, names: "0 15 30 45 60 75 90 105 120", unit: "s" },
    { run: 121, names: "0 1 2 3", unit: "min" },
    { run: 301, names: "0 1 2 3 4 5 6 7 8 9 10", unit: "min" },
    { run: 3_600, names: "0 10 20 30 40 50 60", unit: "min" },
    { run: 7_000, names: "0 15 30 45 60 75 90 105 120", unit: "min" },
    { run: 7_201, names: "0 1 2 3", unit: "h" },
  ])("of a run of $run s names $names $unit", ({ run, names, unit }) => {
    const marks = axisOf(scaleOf(seconds(run), width));
    expect(marks.map(({ value }) => value).join(" ")).toBe(names);
    expect(new Set(marks.map((mark) => mark.unit))).toEqual(new Set([unit]));
  });

  it("of any run on any screen holds it, has room for its names, and ends with one", () => {
    const anyRun = fc.integer({ min: 0, max: 30 * 3_600 * 60 });
    fc.assert(
      fc.property(anyRun, fc.integer({ min: 100, max: 2_000 }), (endTick, pixels) => {
        const scale = scaleOf(endTick, pixels);
        const marks = axisOf(scale);
        expect(scale.span).toBeGreaterThanOrEqual(endTick);
        expect(marks.at(0)?.x).toBe(0);
        expect(marks.at(-1)?.x).toBeCloseTo(pixels, 0);
        const gaps = marks.slice(1).map(({ x }, at) => x - (marks[at]?.x ?? 0));
        expect(marks.length === 2 || Math.min(...gaps) >= 43.5).toBe(true);
      }),
    );
  });
});

describe("a place on the timeline", () => {
  it("is the tick that lies there, to a pixel", () => {
    const anyTick = fc.integer({ min: 0, max: 216_000 });
    fc.assert(
      fc.property(anyTick, fc.integer({ min: 0, max: 216_000 }), (tick, more) => {
        const scale = scaleOf(tick + more, width);
        const back = tickAt(scale, xOf(scale, tick));
        expect(Math.abs(back - tick)).toBeLessThanOrEqual(scale.span / width);
      }),
    );
  });

  it("outside is the nearer end", () => {
    const scale = scaleOf(600, width);
    expect(tickAt(scale, -20)).toBe(0);
    expect(tickAt(scale, width + 20)).toBe(scale.span);
  });
});
