import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { DrawingContext } from "./drawing-context.ts";
import { DirtyRects } from "./dirty-rects.ts";

type Box = [x: number, y: number, width: number, height: number];

const view = { width: 960, height: 640 };

/** The rectangles that `erase` clears, in device pixels. */
function erased(dirty: DirtyRects, pixelRatio: number): Box[] {
  const boxes: Box[] = [];
  const context = {
    setTransform: () => {},
    clearRect: (...box: Box) => boxes.push(box),
  };
  dirty.erase(context as unknown as DrawingContext, pixelRatio, view);
  return boxes;
}

const box = fc.record({
  x: fc.double({ min: 0, max: 900, noNaN: true }),
  y: fc.double({ min: 0, max: 600, noNaN: true }),
  width: fc.double({ min: 0, max: 60, noNaN: true }),
  height: fc.double({ min: 0, max: 40, noNaN: true }),
});

describe("the erased area", () => {
  it("covers everything drawn, for any number of boxes and any pixel density", () => {
    fc.assert(
      fc.property(
        fc.array(box, { maxLength: 100 }),
        fc.double({ min: 0.5, max: 4, noNaN: true }),
        (drawn, pixelRatio) => {
          const dirty = new DirtyRects();
          for (const { x, y, width, height } of drawn) dirty.add(x, y, width, height);
          const boxes = erased(dirty, pixelRatio);
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

  it("consists of whole device pixels, since half a pixel would leave a shadow", () => {
    const dirty = new DirtyRects();
    dirty.addLine(100.3, 50.7, 20.1, 50.7, 9);
    for (const number of erased(dirty, 1.25).flat()) expect(Number.isInteger(number)).toBe(true);
  });

  it("is empty the second time", () => {
    const dirty = new DirtyRects();
    dirty.add(1, 1, 1, 1);
    erased(dirty, 1);
    expect(erased(dirty, 1)).toEqual([]);
  });
});
