import fc from "fast-check";
import { CELL } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import {
  cellAt,
  followScroll,
  layOut,
  viewportAt,
  viewX,
  viewY,
  visibleCells,
  type Padding,
} from "./viewport.ts";

const padding: Padding = { top: 36, right: 34, bottom: 20, left: 70 };
const none = { x: 0, y: 0 };

const anyMaze = fc.record({
  columns: fc.integer({ min: 1, max: 256 }),
  rows: fc.integer({ min: 1, max: 256 }),
});
const anyView = fc.record({
  width: fc.integer({ min: 200, max: 4000 }),
  height: fc.integer({ min: 150, max: 3000 }),
});

describe("layOut", () => {
  it("draws the design's maze with cells of 84 pixels, at the same position", () => {
    const layout = layOut({ columns: 11, rows: 7 }, { width: 1028, height: 644 }, padding, 30);
    expect(layout).toMatchObject({ cellPx: 84, origin: { x: 70, y: 36 }, overflows: false });
  });

  it.each([
    { name: "one square", columns: 1, rows: 1, cellPx: 200, overflows: false },
    { name: "the largest maze", columns: 256, rows: 256, cellPx: 30, overflows: true },
    { name: "a single tall column", columns: 1, rows: 256, cellPx: 30, overflows: true },
    { name: "a single long row", columns: 256, rows: 1, cellPx: 30, overflows: true },
  ])("keeps $name readable", ({ columns, rows, cellPx, overflows }) => {
    const layout = layOut({ columns, rows }, { width: 1028, height: 644 }, padding, 30);
    expect(layout).toMatchObject({ cellPx, overflows });
  });

  it("shows the whole maze or fills the room, and never leaves the padding", () => {
    fc.assert(
      fc.property(anyMaze, anyView, (maze, view) => {
        const { port, cellPx, overflows, content, origin } = layOut(maze, view, padding, 30);
        expect(Number.isInteger(cellPx)).toBe(true);
        expect(port.x).toBeGreaterThanOrEqual(padding.left);
        expect(port.y).toBeGreaterThanOrEqual(padding.top);
        expect(port.x + port.width).toBeLessThanOrEqual(
          Math.max(view.width - padding.right, padding.left + 1),
        );
        expect(content.width).toBeGreaterThanOrEqual(origin.x + maze.columns * cellPx);
        expect(content.height).toBeGreaterThanOrEqual(origin.y + maze.rows * cellPx);
        const isWhole = port.width === maze.columns * cellPx && port.height === maze.rows * cellPx;
        expect(isWhole).toBe(!overflows);
      }),
    );
  });
});

describe("a point on the screen", () => {
  it("belongs to the cell that is drawn there", () => {
    fc.assert(
      fc.property(anyMaze, anyView, fc.nat(), fc.nat(), (maze, view, c, r) => {
        const cell = { column: c % maze.columns, row: r % maze.rows };
        const layout = layOut(maze, view, padding, 30);
        const viewport = viewportAt(layout, none);
        const x = viewX(viewport, (cell.column + 0.5) * CELL) - layout.origin.x;
        const y = viewY(viewport, (cell.row + 0.5) * CELL) - layout.origin.y;
        expect(cellAt(layout, x, y)).toEqual(cell);
      }),
    );
  });

  it.each([
    { x: -1, y: 5 },
    { x: 5, y: -1 },
    { x: 924, y: 5 },
    { x: 5, y: 588 },
  ])("outside of the maze at $x, $y belongs to no cell", ({ x, y }) => {
    const layout = layOut({ columns: 11, rows: 7 }, { width: 1028, height: 644 }, padding, 30);
    expect(cellAt(layout, x, y)).toBeNull();
  });
});

describe("visibleCells", () => {
  it("is the whole maze where it fits", () => {
    const layout = layOut({ columns: 11, rows: 7 }, { width: 1028, height: 644 }, padding, 30);
    expect(visibleCells(viewportAt(layout, none))).toEqual({
      fromColumn: 0,
      toColumn: 11,
      fromRow: 0,
      toRow: 7,
    });
  });

  it("is about a thousand of the largest maze's 65,536 squares", () => {
    const layout = layOut({ columns: 256, rows: 256 }, { width: 1028, height: 644 }, padding, 30);
    const seen = visibleCells(viewportAt(layout, { x: 3000, y: 3000 }));
    const count = (seen.toColumn - seen.fromColumn) * (seen.toRow - seen.fromRow);
    expect(seen.fromColumn).toBe(100);
    expect(count).toBeLessThan(1000);
  });
});

describe("followScroll", () => {
  const layout = layOut({ columns: 256, rows: 256 }, { width: 1028, height: 644 }, padding, 30);

  it("stays while the robot is well inside the view", () => {
    const scroll = { x: 3000, y: 3000 };
    expect(followScroll(layout, scroll, 11_500, 11_000)).toEqual(scroll);
  });

  it("scrolls the robot into view wherever it is and however the stage was scrolled", () => {
    const within = fc.integer({ min: 25, max: 25_575 });
    const scrolled = fc.record({
      x: fc.integer({ min: 0, max: layout.content.width - layout.view.width }),
      y: fc.integer({ min: 0, max: layout.content.height - layout.view.height }),
    });
    fc.assert(
      fc.property(within, within, scrolled, (x, y, before) => {
        const scroll = followScroll(layout, before, x, y);
        const viewport = viewportAt(layout, scroll);
        const { port } = viewport;
        expect(viewX(viewport, x)).toBeGreaterThan(port.x);
        expect(viewX(viewport, x)).toBeLessThan(port.x + port.width);
        expect(viewY(viewport, y)).toBeGreaterThan(port.y);
        expect(viewY(viewport, y)).toBeLessThan(port.y + port.height);
        expect(scroll.x).toBeLessThanOrEqual(layout.content.width - layout.view.width);
        expect(scroll.y).toBeLessThanOrEqual(layout.content.height - layout.view.height);
      }),
    );
  });
});
