import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { normaliseHeading, writeUnitVector } from "./heading.ts";

function unitVector(heading: number): { x: number; y: number } {
  const out = new Float64Array(2);
  writeUnitVector(heading, out);
  return { x: out[0] ?? Number.NaN, y: out[1] ?? Number.NaN };
}

describe("writeUnitVector", () => {
  it.each([
    { name: "north", heading: 0, x: 0, y: -1 },
    { name: "east", heading: 90, x: 1, y: 0 },
    { name: "south", heading: 180, x: 0, y: 1 },
    { name: "west", heading: 270, x: -1, y: 0 },
  ])("is exact to the last bit when heading $name", ({ heading, x, y }) => {
    const vector = unitVector(heading);
    expect(vector.x + 0).toBe(x);
    expect(vector.y + 0).toBe(y);
  });

  it("matches sine and cosine within 2e-15 for every heading", () => {
    fc.assert(
      fc.property(fc.double({ min: 0, max: 359.999999, noNaN: true }), (heading) => {
        const { x, y } = unitVector(heading);
        const radians = (heading * Math.PI) / 180;
        expect(Math.abs(x - Math.sin(radians))).toBeLessThan(2e-15);
        expect(Math.abs(y + Math.cos(radians))).toBeLessThan(2e-15);
      }),
    );
  });
});

describe("normaliseHeading", () => {
  it.each([
    { degrees: 0, heading: 0 },
    { degrees: 360, heading: 0 },
    { degrees: -90, heading: 270 },
    { degrees: 725, heading: 5 },
    { degrees: -1e-20, heading: 0 },
  ])("returns $heading for $degrees degrees", ({ degrees, heading }) => {
    expect(normaliseHeading(degrees)).toBe(heading);
  });

  it("always returns a value in [0, 360)", () => {
    fc.assert(
      fc.property(fc.double({ min: -1e6, max: 1e6, noNaN: true }), (degrees) => {
        const heading = normaliseHeading(degrees);
        expect(heading).toBeGreaterThanOrEqual(0);
        expect(heading).toBeLessThan(360);
      }),
    );
  });
});
