import { describe, expect, it } from "vitest";
import { Trail } from "./trail.ts";

function drive(trail: Trail, points: [number, number][]): number[] {
  for (const [x, y] of points) trail.add(x, y);
  return trail.take().corners;
}

describe("the trail", () => {
  it("keeps one point for a straight line however long it is", () => {
    const trail = new Trail();
    trail.reset(50, 50);
    const line = Array.from({ length: 1000 }, (_, i): [number, number] => [50 + (i + 1) * 1.7, 50]);
    expect(drive(trail, line).length).toBeLessThanOrEqual(4);
  });

  it("has a corner where the robot turned and where it went back", () => {
    const trail = new Trail();
    trail.reset(0, 0);
    trail.take();
    const corners = drive(trail, [
      [10, 0],
      [20, 0],
      [20, 10],
      [20, 5],
    ]);
    expect(corners).toEqual([0, 0, 20, 0, 20, 10]);
  });

  it("follows a gentle curve within half a centimetre", () => {
    const trail = new Trail();
    trail.reset(0, 0);
    const points = Array.from({ length: 600 }, (_, i): [number, number] => {
      const angle = (i + 1) / 2000;
      return [1000 * Math.sin(angle), 1000 * (1 - Math.cos(angle))];
    });
    const corners = drive(trail, points);
    expect(corners.length).toBeGreaterThan(100);
  });

  it("ignores a robot that stands", () => {
    const trail = new Trail();
    trail.reset(5, 5);
    expect(trail.take()).toEqual({ corners: [5, 5], trailReset: true });
    trail.add(5, 5);
    expect(trail.take()).toEqual({ corners: [], trailReset: false });
  });
});
