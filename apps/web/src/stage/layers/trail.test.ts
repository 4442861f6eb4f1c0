import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { eachDot } from "./trail.ts";

function dots(x0: number, y0: number, x1: number, y1: number): [number, number][] {
  const found: [number, number][] = [];
  eachDot(x0, y0, x1, y1, (x, y) => found.push([x, y]));
  return found;
}

describe("the dots of the trail", () => {
  it.each([
    { name: "eastward", line: [50, 650, 110, 650], at: ["50,650", "75,650", "100,650"] },
    { name: "northward", line: [450, 60, 450, 20], at: ["450,25", "450,50"] },
    { name: "nowhere", line: [50, 50, 50, 50], at: [] },
    { name: "a segment too short for one", line: [51, 50, 60, 50], at: [] },
  ] as const)("stand every 25 cm: $name", ({ line, at }) => {
    const [x0, y0, x1, y1] = line;
    expect(dots(x0, y0, x1, y1).map(String)).toEqual(at);
  });

  it("are at the same positions when the robot drives back", () => {
    const snapTo = fc.integer({ min: 0, max: 25_600 });
    fc.assert(
      fc.property(snapTo, snapTo, snapTo, (from, to, across) => {
        expect(dots(to, across, from, across)).toEqual(dots(from, across, to, across));
      }),
    );
  });

  it("are the same for a path in one piece and in two", () => {
    fc.assert(
      fc.property(fc.nat(2000), fc.nat(2000), fc.nat(2000), (a, b, c) => {
        const [from = 0, middle = 0, to = 0] = [a, b, c].sort((p, q) => p - q);
        const pieces = [...dots(from, 50, middle, 50), ...dots(middle, 50, to, 50)];
        expect(new Set(pieces.map(String))).toEqual(new Set(dots(from, 50, to, 50).map(String)));
      }),
    );
  });
});
