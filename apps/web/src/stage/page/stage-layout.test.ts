import { describe, expect, it } from "vitest";
import { centredScroll, viewportAt, viewY } from "../drawing/viewport.ts";
import { scaleBar } from "./scale-bar.ts";
import { divideStage, hasRulers, stageLayout } from "./stage-layout.ts";

const maze = { columns: 11, rows: 7 };

describe("stageLayout", () => {
  it("leaves room for the rulers on a wide stage", () => {
    const { cellPx, origin } = stageLayout(maze, { width: 1028, height: 644 }, true);
    expect({ cellPx, origin }).toEqual({ cellPx: 84, origin: { x: 70, y: 36 } });
  });

  it("gives the rulers' room to the maze when they are hidden", () => {
    const { origin } = stageLayout({ columns: 30, rows: 7 }, { width: 1028, height: 644 }, false);
    expect(origin.x).toBeLessThan(70);
  });

  it.each([
    { width: 390, height: 300, cellPx: 30 },
    { width: 320, height: 300, cellPx: 24 },
    { width: 390, height: 160, cellPx: 17 },
    { width: 320, height: 108, cellPx: 14 },
  ])("shows the whole maze in $width x $height px of a phone", ({ width, height, cellPx }) => {
    const layout = stageLayout(maze, { width, height }, true);
    expect(layout).toMatchObject({ cellPx, overflows: false });
    expect(hasRulers(width, true)).toBe(false);
  });
});

describe("a large maze", () => {
  const view = { width: 1028, height: 644 };

  it("opens whole at 21 by 21 squares on a screen of 1440 by 900", () => {
    const layout = stageLayout({ columns: 21, rows: 21 }, view, true);
    expect(layout).toMatchObject({ cellPx: 28, overflows: false });
  });

  it("opens with squares of 30 pixels where it does not fit", () => {
    const layout = stageLayout({ columns: 37, rows: 37 }, view, true);
    expect(layout).toMatchObject({ cellPx: 30, overflows: true });
  });

  it("fits as a whole on request, the largest one too", () => {
    const layout = stageLayout({ columns: 256, rows: 256 }, view, true, "fit");
    expect(layout).toMatchObject({ cellPx: 2, overflows: false });
  });

  it("has squares of the size that the reader chose", () => {
    const layout = stageLayout({ columns: 5, rows: 5 }, view, true, 200.4);
    expect(layout).toMatchObject({ cellPx: 200, overflows: true });
  });
});

describe("the camera", () => {
  it("shows a robot at the upper end of the maze below the button over the stage", () => {
    const layout = divideStage({
      maze: { columns: 21, rows: 21 },
      view: { width: 390, height: 300 },
      showRulers: false,
      follows: true,
      zoom: null,
    });
    expect(layout.follows).toBe(true);
    const viewport = viewportAt(layout, centredScroll(layout, 2075, 25));
    const button = 8 + 44;
    const reading = 22;
    expect(viewY(viewport, 0) - reading).toBeGreaterThan(button);
  });
});

describe("scaleBar", () => {
  it.each([
    { cellPx: 200, units: 50, width: 100 },
    { cellPx: 84, units: 100, width: 84 },
    { cellPx: 49, units: 200, width: 98 },
    { cellPx: 30, units: 500, width: 150 },
  ])("is $units cm long at $cellPx px a square", ({ cellPx, units, width }) => {
    const bar = scaleBar(cellPx);
    expect(bar).toMatchObject({ units, width });
    expect(bar.ticks.at(-1)).toBe(width);
  });
});
