import fc from "fast-check";
import { describe, expect, it } from "vitest";
import {
  lengthInside,
  markCentres,
  placeLabels,
  readingCentres,
  type LabelRequest,
} from "./label-placement.ts";
import type { Box } from "./viewport.ts";

const bounds: Box = { x: 70, y: 36, width: 924, height: 588 };
const sides = ["front", "right", "back", "left"] as const;
type Side = (typeof sides)[number];
const directions: Record<Side, { dx: number; dy: number }> = {
  front: { dx: 0, dy: -1 },
  right: { dx: 1, dy: 0 },
  back: { dx: 0, dy: 1 },
  left: { dx: -1, dy: 0 },
};

/** Four readings of 36 x 22 pixels around a robot, as the stage requests them. */
function readings(x: number, y: number, radius: number, lengths: Record<Side, number>) {
  const robot: Box = { x: x - radius, y: y - radius, width: 2 * radius, height: 2 * radius };
  const requests = sides.map((name): LabelRequest<Side> => {
    const beam = { origin: { x, y }, ...directions[name] };
    const centres = readingCentres(beam, lengths[name], radius, 36, 22);
    return { name, sizes: [{ width: 36, height: 22, centres }] };
  });
  return { robot, placed: placeLabels(requests, [robot], bounds) };
}

function overlap(a: Box, b: Box): boolean {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

describe("the readings", () => {
  it("stand at the wall end of long beams", () => {
    const { placed } = readings(500, 300, 22, { front: 200, right: 210, back: 300, left: 400 });
    expect(placed).toEqual([
      { name: "front", x: 482, y: 104, width: 36, height: 22 },
      { name: "right", x: 670, y: 289, width: 36, height: 22 },
      { name: "back", x: 482, y: 574, width: 36, height: 22 },
      { name: "left", x: 104, y: 289, width: 36, height: 22 },
    ]);
  });

  it("stand beyond the wall where the beam is shorter than the label", () => {
    const { placed } = readings(500, 300, 22, { front: 200, right: 42, back: 300, left: 42 });
    expect(placed.find(({ name }) => name === "right")?.x).toBe(548);
    expect(placed.find(({ name }) => name === "left")?.x).toBe(416);
  });

  it("leave a flag at the end of their beam visible, and cover it if no other position is free", () => {
    const beam = { origin: { x: 500, y: 300 }, ...directions.left };
    const centres = readingCentres(beam, 120, 22, 36, 22);
    const request = { name: "left", sizes: [{ width: 36, height: 22, centres }] };
    const flag: Box = { x: 389, y: 289, width: 22, height: 22 };
    expect(placeLabels([request], [], bounds, [flag])).toMatchObject([{ x: 338, y: 289 }]);
    const corridor: Box = { x: 380, y: 280, width: 100, height: 40 };
    expect(placeLabels([request], [], corridor, [flag])).toMatchObject([{ x: 384, y: 289 }]);
  });

  it("never cover the robot or each other and never leave the maze", () => {
    const along = (from: number, length: number) =>
      fc.double({ min: from + 21, max: from + length - 21, noNaN: true });
    const length = fc.double({ min: 21, max: 2000, noNaN: true });
    fc.assert(
      fc.property(
        along(bounds.x, bounds.width),
        along(bounds.y, bounds.height),
        fc.double({ min: 7, max: 60, noNaN: true }),
        fc.record({ front: length, right: length, back: length, left: length }),
        (x, y, radius, lengths) => {
          const { robot, placed } = readings(x, y, radius, lengths);
          for (const [index, label] of placed.entries()) {
            expect(overlap(label, robot)).toBe(false);
            for (const other of placed.slice(index + 1)) expect(overlap(label, other)).toBe(false);
            expect(label.x).toBeGreaterThanOrEqual(bounds.x);
            expect(label.y).toBeGreaterThanOrEqual(bounds.y);
            expect(label.x + label.width).toBeLessThanOrEqual(bounds.x + bounds.width);
            expect(label.y + label.height).toBeLessThanOrEqual(bounds.y + bounds.height);
          }
        },
      ),
    );
  });
});

describe("the number of a line", () => {
  const beam = { origin: { x: 500, y: 300 }, dx: 1, dy: 0 };
  const centres = markCentres(beam, 60, 13, 42, 18);
  const request = { name: 1, sizes: [{ width: 42, height: 18, centres }] };

  it("stands below its bar", () => {
    expect(placeLabels([request], [], bounds)).toEqual([
      { name: 1, x: 539, y: 313, width: 42, height: 18 },
    ]);
  });

  it("changes sides where a reading stands", () => {
    const reading: Box = { x: 520, y: 310, width: 80, height: 22 };
    expect(placeLabels([request], [reading], bounds)[0]).toMatchObject({ x: 539, y: 269 });
  });

  it("is omitted if there is no room", () => {
    expect(placeLabels([request], [bounds], bounds)).toEqual([]);
  });
});

describe("lengthInside", () => {
  it.each([
    { dx: 0, dy: -1, length: 264 },
    { dx: 1, dy: 0, length: 494 },
    { dx: 0, dy: 1, length: 324 },
    { dx: -1, dy: 0, length: 430 },
    { dx: 0.6, dy: 0.8, length: 405 },
  ])("along $dx, $dy is $length", ({ dx, dy, length }) => {
    expect(lengthInside({ origin: { x: 500, y: 300 }, dx, dy }, bounds)).toBeCloseTo(length, 9);
  });
});
