import type { MazeDocument } from "@corridor/maze";
import fc from "fast-check";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import { DirtyRects } from "../drawing/dirty-rects.ts";
import { readPalette } from "../drawing/palette.ts";
import { layOut, viewportAt } from "../drawing/viewport.ts";
import { touchOf } from "./bumps.ts";
import { drawHit, recoilDirection, hitSensor, isAtHit, type Hit } from "./hit.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: ["..#", "...", "..."],
  start: { column: 0, row: 0, heading: "east" },
  goals: [],
};
/** At the west side of the block. */
const hit: Hit = { pose: { x: 175, y: 50, heading: 90 }, wanted: 26 };

const allAt = (cm: number) => ({ front: cm, right: cm, back: cm, left: cm });

const seen = (heading: number) => ({
  pose: { ...hit.pose, heading },
  sensors: heading % 90 === 0 ? allAt(25) : allAt(35.4),
});

describe("a displayed bump", () => {
  it.each([
    { name: "stays while the robot stands at it", pose: hit.pose, isShown: true },
    { name: "stays while the robot turns there", pose: { ...hit.pose, heading: 0 }, isShown: true },
    { name: "ends once the robot has driven away", pose: { ...hit.pose, x: 173 }, isShown: false },
  ])("$name", ({ pose, isShown }) => {
    expect(isAtHit(hit, pose)).toBe(isShown);
    expect(isAtHit(null, pose)).toBe(false);
  });

  it.each([
    { heading: 90, sensor: "front" },
    { heading: 0, sensor: "right" },
    { heading: 270, sensor: "back" },
    { heading: 180, sensor: "left" },
    { heading: 45, sensor: null },
  ])(
    "names the sensor that measures the wall: $sensor at heading $heading",
    ({ heading, sensor }) => {
      expect(hitSensor(maze, hit, seen(heading))).toBe(sensor);
    },
  );

  it("names no sensor where the beam misses the corner that was hit", () => {
    // 4 units beside the block, so the beam ahead continues for 225 units.
    const corner: Hit = { pose: { x: 175.3, y: 104, heading: 90 }, wanted: null };
    const sensors = { front: 225, right: 196, back: 175, left: 104 };
    expect(hitSensor(maze, corner, { pose: corner.pose, sensors })).toBeNull();
    expect(touchOf(maze, corner.pose)).toEqual({
      x: 200,
      y: 100,
      cell: { column: 2, row: 0 },
      isCorner: true,
    });
  });

  it("names no sensor where the wall has been removed since", () => {
    expect(hitSensor({ ...maze, blocks: ["...", "...", "..."] }, hit, seen(90))).toBeNull();
  });

  it("recoils away from the wall", () => {
    const { dx, dy } = recoilDirection(maze, hit);
    expect(dx).toBeCloseTo(-1, 6);
    expect(dy).toBeCloseTo(0, 6);
  });
});

it("erases the block that was hit, also if the run is one of a larger maze that is not displayed yet", () => {
  vi.stubGlobal("Path2D", class {});
  onTestFinished(() => void vi.unstubAllGlobals());
  const layout = layOut(
    { columns: 3, rows: 3 },
    { width: 400, height: 400 },
    { top: 36, right: 34, bottom: 20, left: 70 },
    30,
  );
  const viewport = viewportAt(layout, { x: 0, y: 0 });
  const place = fc.integer({ min: -2, max: 20 }).map((squares) => 50 * squares + 25);
  const pose = fc.record({ x: place, y: place, heading: fc.constantFrom(0, 90, 180, 270) });
  fc.assert(
    fc.property(pose, (at) => {
      const boxes: number[][] = [];
      const erased: number[][] = [];
      const context = new Proxy({} as DrawingContext, {
        get: (_, name) => {
          if (name === "fillRect") return (...box: number[]) => boxes.push(box);
          if (name === "clearRect") return (...box: number[]) => erased.push(box);
          return () => undefined;
        },
        set: () => true,
      });
      const dirty = new DirtyRects();
      const palette = readPalette(() => "black");
      drawHit(context, viewport, palette, maze, { pose: at, wanted: 26 }, dirty);
      dirty.erase(context, 1, { width: 400, height: 400 });
      for (const [x = 0, y = 0, width = 0, height = 0] of boxes) {
        const isInside = ([left = 0, top = 0, wide = 0, high = 0]: number[]): boolean =>
          left <= x && top <= y && left + wide >= x + width && top + high >= y + height;
        expect(Math.min(width, height)).toBeGreaterThan(0);
        expect(erased.some(isInside)).toBe(true);
      }
    }),
  );
});
