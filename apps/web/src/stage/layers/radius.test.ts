import type { MazeDocument } from "@corridor/maze";
import type { Pose } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { divideStage } from "../page/stage-layout.ts";
import type { DrawingContext } from "../drawing/drawing-context.ts";
import { DirtyRects } from "../drawing/dirty-rects.ts";
import { readPalette } from "../drawing/palette.ts";
import { followScroll, viewportAt, viewX, viewY } from "../drawing/viewport.ts";
import { drawRadius, placeRadiusLabel } from "./radius.ts";
import { robotBox } from "./robot.ts";

const SIDE = 7;
const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "",
  blocks: Array.from({ length: SIDE }, () => ".".repeat(SIDE)),
  start: { column: 0, row: 0, heading: "north" },
  goals: [],
};
const context = new Proxy({}, { get: () => () => undefined, set: () => true }) as DrawingContext;
const palette = readPalette(() => "black");

/** A robot that touches an outer wall while it drives towards it at an angle. */
const touching = fc
  .record({
    quarter: fc.constantFrom(0, 90, 180, 270),
    slant: fc.integer({ min: -80, max: 80 }),
    along: fc.double({ min: 25, max: SIDE * 100 - 25, noNaN: true }),
  })
  .map(({ quarter, slant, along }): Pose => {
    const far = SIDE * 100 - 25;
    const heading = (quarter + slant + 360) % 360;
    if (quarter === 0) return { x: along, y: 25, heading };
    if (quarter === 90) return { x: far, y: along, heading };
    return quarter === 180 ? { x: along, y: far, heading } : { x: 25, y: along, heading };
  });
const view = fc.constantFrom(
  { width: 320, height: 120 },
  { width: 320, height: 190 },
  { width: 390, height: 640 },
  { width: 1028, height: 644 },
);

describe("the label of the radius", () => {
  it("is fully visible at every outer wall, beside the robot", () => {
    fc.assert(
      fc.property(touching, view, fc.boolean(), (pose, size, showRulers) => {
        const room = { maze: { columns: SIDE, rows: SIDE }, view: size, showRulers };
        const layout = divideStage({ ...room, follows: false, zoom: null });
        const viewport = viewportAt(layout, followScroll(layout, { x: 0, y: 0 }, pose.x, pose.y));
        const dirty = new DirtyRects();
        const measure = drawRadius(context, viewport, palette, maze, pose, dirty);
        if (measure === null) throw new Error("The robot touches a wall.");
        const label = placeRadiusLabel(viewport, measure);
        if (label === null) throw new Error("The label has no place.");
        expect(label.x).toBeGreaterThanOrEqual(0);
        expect(label.y).toBeGreaterThanOrEqual(0);
        expect(label.x + label.width).toBeLessThanOrEqual(size.width);
        expect(label.y + label.height).toBeLessThanOrEqual(size.height);
        const robot = robotBox(viewport, {
          x: viewX(viewport, pose.x),
          y: viewY(viewport, pose.y),
        });
        const isApart =
          label.x >= robot.x + robot.width ||
          robot.x >= label.x + label.width ||
          label.y >= robot.y + robot.height ||
          robot.y >= label.y + label.height;
        expect(isApart).toBe(true);
      }),
      { numRuns: 500 },
    );
  });
});
