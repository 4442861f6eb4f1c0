import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { Brush } from "./brush.ts";
import { Dirt } from "./dirt.ts";

type Box = [x: number, y: number, width: number, height: number];

const view = { width: 960, height: 640 };

/** The rectangles that a wipe empties, in device pixels. */
function wiped(dirt: Dirt, pixelRatio: number): Box[] {
  const boxes: Box[] = [];
  const brush = {
    setTransform: () => {},
    clearRect: (...box: Box) => boxes.push(box),
  };
  dirt.wipe(brush as unknown as Brush, pixelRatio, view);
  return boxes;
}

const box = fc.record({
  x: fc.double({ min: 0, max: 900, noNaN: true }),
  y: fc.double({ min: 0, max: 600, noNaN: true }),
  width: fc.double({ min: 0, max: 60, noNaN: true }),
  height: fc.double({ min: 0, max: 40, noNaN: true }),
});

describe("what a wipe empties", () => {
  it("covers all that was drawn, however many boxes there were, at any density of pixels", () => {
    fc.assert(
      fc.property(
        fc.array(box, { maxLength: 100 }),
        fc.double({ min: 0.5, max: 4, noNaN: true }),
        (drawn, pixelRatio) => {
          const dirt = new Dirt();
          for (const { x, y, width, height } of drawn) dirt.add(x, y, width, height);
          const boxes = wiped(dirt, pixelRatio);
          for (const { x, y, width, height } of drawn) {
            const isCovered = boxes.some(
              ([left, top, wide, high]) =>
                left <= x * pixelRatio &&
                top <= y * pixelRatio &&
                left + wide >= Math.min(x + width, view.width) * pixelRatio &&
                top + high >= Math.min(y + height, view.height) * pixelRatio,
            );
            expect(isCovered).toBe(true);
          }
        },
      ),
    );
  });

  it("is made of whole device pixels, since half a pixel would leave a shadow", () => {
    const dirt = new Dirt();
    dirt.addLine(100.3, 50.7, 20.1, 50.7, 9);
    for (const number of wiped(dirt, 1.25).flat()) expect(Number.isInteger(number)).toBe(true);
  });

  it("is nothing twice", () => {
    const dirt = new Dirt();
    dirt.add(1, 1, 1, 1);
    wiped(dirt, 1);
    expect(wiped(dirt, 1)).toEqual([]);
  });
});
