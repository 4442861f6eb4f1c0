import { describe, expect, it } from "vitest";
import { around, clampCell, moveCursor, isAround } from "./grid-cursor.ts";

const size = { columns: 11, rows: 30 };
const from = { column: 5, row: 15 };
const plain = { ctrlKey: false, metaKey: false, altKey: false };

describe("moveCursor", () => {
  it.each([
    { key: "ArrowUp", to: { column: 5, row: 14 } },
    { key: "ArrowDown", to: { column: 5, row: 16 } },
    { key: "ArrowLeft", to: { column: 4, row: 15 } },
    { key: "ArrowRight", to: { column: 6, row: 15 } },
    { key: "Home", to: { column: 0, row: 15 } },
    { key: "End", to: { column: 10, row: 15 } },
    { key: "PageUp", to: { column: 5, row: 5 } },
    { key: "PageDown", to: { column: 5, row: 25 } },
    { key: "a", to: null },
  ])("$key leads to $to", ({ key, to }) => {
    expect(moveCursor(from, { ...plain, key }, size)).toEqual(to);
  });

  it.each([
    { key: "Home", to: { column: 0, row: 0 } },
    { key: "End", to: { column: 10, row: 29 } },
    { key: "ArrowUp", to: null },
  ])("with Ctrl, $key leads to $to", ({ key, to }) => {
    expect(moveCursor(from, { ...plain, ctrlKey: true, key }, size)).toEqual(to);
  });

  it.each(["ArrowUp", "ArrowLeft", "PageUp", "Home"])("%s stays in the first corner", (key) => {
    const corner = { column: 0, row: 0 };
    expect(moveCursor(corner, { ...plain, key }, size)).toEqual(corner);
  });

  it("leaves Alt and an arrow to the browser", () => {
    expect(moveCursor(from, { ...plain, altKey: true, key: "ArrowLeft" }, size)).toBeNull();
  });
});

describe("clampCell", () => {
  it("moves along when the maze becomes smaller", () => {
    expect(clampCell(from, { columns: 1, rows: 3 })).toEqual({ column: 0, row: 2 });
  });
});

describe("isAround", () => {
  it("returns the same cells as around", () => {
    const cursor = { column: 0, row: 3 };
    const size = { columns: 5, rows: 5 };
    for (let row = 0; row < size.rows; row++) {
      for (let column = 0; column < size.columns; column++) {
        const exists =
          around(cursor.row, size.rows).includes(row) &&
          around(cursor.column, size.columns).includes(column);
        expect(isAround(cursor, { column, row })).toBe(exists);
      }
    }
  });
});

describe("around", () => {
  it.each([
    { at: 0, count: 1, window: [0] },
    { at: 0, count: 256, window: [0, 1] },
    { at: 100, count: 256, window: [99, 100, 101] },
    { at: 255, count: 256, window: [254, 255] },
  ])("of $at in $count is $window", ({ at, count, window }) => {
    expect(around(at, count)).toEqual(window);
  });
});
