import { describe, expect, it } from "vitest";
import { Trail } from "./trail.ts";

describe("Trail", () => {
  it("is nothing before the first frame", () => {
    expect(new Trail().points()).toEqual([]);
  });

  it("is empty before the first frame", () => {
    const trail = new Trail();
    expect(trail.add([50, 50], { x: 50, y: 50 }, true).kind).toBe("replaced");
    const grown = trail.add([], { x: 90, y: 50 }, false);
    expect(grown).toEqual({ kind: "grown", points: [50, 50, 90, 50] });
    expect(trail.add([50, 50], { x: 50, y: 50 }, true).kind).toBe("replaced");
    expect(trail.points()).toEqual([50, 50, 50, 50]);
  });

  it("draws everything at the first frame and at a reset, and only the new piece after it", () => {
    const trail = new Trail();
    trail.add([50, 50], { x: 50, y: 50 }, true);
    expect(trail.add([], { x: 50, y: 50 }, false)).toEqual({ kind: "none" });
  });

  it("requests no drawing while the robot stands still", () => {
    const trail = new Trail();
    trail.add([50, 50], { x: 50, y: 50 }, true);
    trail.add([], { x: 80, y: 50 }, false);
    trail.add([100, 50], { x: 100, y: 70 }, false);
    expect(trail.add([], { x: 100, y: 72 }, false)).toEqual({
      kind: "grown",
      points: [100, 50, 100, 70, 100, 72],
    });
  });

  it("draws a piece that overlaps the last one by no more than it needs", () => {
    const trail = new Trail();
    trail.add([50, 50], { x: 50, y: 50 }, true);
    trail.add([150, 50, 150, 150], { x: 90, y: 150 }, false);
    expect(trail.points()).toEqual([50, 50, 150, 50, 150, 150, 90, 150]);
  });

  it("stores every corner, however many come with one frame", () => {
    const trail = new Trail();
    trail.add([0, 0], { x: 0, y: 0 }, true);
    const many = Array.from({ length: 40_000 }, (_, at) => at);
    expect(trail.add(many, { x: 1, y: 1 }, false).kind).toBe("replaced");
    const points = trail.points();
    expect(points.length).toBeLessThanOrEqual(40_002);
    expect(points.slice(-4)).toEqual([39_998, 39_999, 1, 1]);
  });
});
