import { describe, expect, it } from "vitest";
import { nextTile } from "./next-tile.ts";

const grid = { count: 10, columns: 4, isRtl: false };

describe("arrow keys in the grid of mazes", () => {
  it.each([
    { key: "ArrowRight", from: 0, to: 1 },
    { key: "ArrowLeft", from: 5, to: 4 },
    { key: "ArrowDown", from: 1, to: 5 },
    { key: "ArrowUp", from: 9, to: 5 },
    { key: "Home", from: 7, to: 0 },
    { key: "End", from: 7, to: 9 },
    { key: "ArrowDown", from: 7, to: null },
    { key: "ArrowLeft", from: 0, to: null },
    { key: "Enter", from: 3, to: null },
    { key: "ArrowRight", from: -1, to: null },
  ])("$key leads from $from to $to", ({ key, from, to }) => {
    expect(nextTile({ ...grid, key, from })).toBe(to);
  });

  it("follow the text direction in right-to-left languages", () => {
    expect(nextTile({ ...grid, isRtl: true, key: "ArrowLeft", from: 0 })).toBe(1);
    expect(nextTile({ ...grid, isRtl: true, key: "ArrowRight", from: 1 })).toBe(0);
    expect(nextTile({ ...grid, isRtl: true, key: "ArrowDown", from: 1 })).toBe(5);
  });
});
