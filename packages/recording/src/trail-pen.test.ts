import { describe, expect, it } from "vitest";
import { TrailPen } from "./trail-pen.ts";

/** Corners of the trail through the given points, x and y alternating. */
function cornersOf([first, ...points]: [[number, number], ...[number, number][]]): number[] {
  const pen = new TrailPen(...first);
  const corners: number[] = [...first];
  for (const point of points) {
    if (pen.moveTo(...point)) corners.push(pen.cornerX, pen.cornerY);
  }
  return corners;
}

describe("the trail", () => {
  it("has at most two points for a straight line of any length", () => {
    const line = Array.from({ length: 1000 }, (_, i): [number, number] => [50 + (i + 1) * 1.7, 50]);
    expect(cornersOf([[50, 50], ...line]).length).toBeLessThanOrEqual(4);
  });

  it("has a corner where the robot turned or reversed", () => {
    const corners = cornersOf([
      [0, 0],
      [10, 0],
      [20, 0],
      [20, 10],
      [20, 5],
    ]);
    expect(corners.slice(2)).toEqual([0, 0, 20, 0, 20, 10]);
  });

  it("follows a gentle curve within half a centimetre", () => {
    const points = Array.from({ length: 600 }, (_, i): [number, number] => {
      const angle = (i + 1) / 2000;
      return [1000 * Math.sin(angle), 1000 * (1 - Math.cos(angle))];
    });
    expect(cornersOf([[0, 0], ...points]).length).toBeGreaterThan(100);
  });

  it("has no corner while the robot stands still", () => {
    expect(
      cornersOf([
        [5, 5],
        [5, 5],
      ]),
    ).toEqual([5, 5]);
  });

  it("continues from a saved state", () => {
    const pen = new TrailPen(0, 0);
    pen.moveTo(10, 0);
    const saved = structuredClone(pen.save());
    const other = new TrailPen(7, 7);
    other.restore(saved);
    for (const each of [pen, other]) {
      expect(each.moveTo(20, 0)).toBe(false);
      expect(each.moveTo(20, 10)).toBe(true);
    }
  });
});
