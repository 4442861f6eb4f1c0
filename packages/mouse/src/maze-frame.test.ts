import { mazePresets, type MazeDocument } from "@corridor/maze";
import { describe, expect, it } from "vitest";
import { MazeFrame } from "./maze-frame.ts";

function mazeOf(blocks: string[], start: MazeDocument["start"]): MazeDocument {
  return { format: "corridor/maze", version: 1, name: "", blocks, start, goals: [] };
}

const posts = ["#######", "#.....#", "#.###.#", "#...#.#", "#######"];
const bordered = ["######", "#....#", "#.##.#", "#....#", "######"];
const open = ["...", ".#."];

describe("a maze", () => {
  it.each([
    { name: "of posts and walls", blocks: posts, start: [1, 3], size: [3, 2], block: [5, 1] },
    {
      name: "with a border of blocks",
      blocks: bordered,
      start: [1, 3],
      size: [4, 3],
      block: [4, 1],
    },
    { name: "without a border", blocks: open, start: [0, 1], size: [3, 2], block: [2, 0] },
  ])("$name has cells from the bottom left", ({ blocks, start, size, block }) => {
    const [column = 0, row = 0] = start;
    const frame = new MazeFrame(mazeOf(blocks, { column, row, heading: "north" }));
    expect([frame.columns, frame.rows]).toEqual(size);
    const cell = (x: number, y: number): number[] => Object.values(frame.blockOf({ x, y }));
    expect(cell(0, 0)).toEqual(start);
    expect(cell(frame.columns - 1, frame.rows - 1)).toEqual(block);
    const pose = { x: column * 100 + 50, y: row * 100 + 50, heading: 90 };
    expect(frame.placeOf(pose)).toEqual({ x: 1, y: 1 });
    expect(frame.eighthsOf(pose.heading)).toBe(2);
  });

  it.each([
    { start: [1, 3], north: 0, size: [3, 2], end: [5, 1] },
    { start: [1, 1], north: 90, size: [2, 3], end: [5, 3] },
    { start: [5, 1], north: 180, size: [3, 2], end: [1, 3] },
    { start: [5, 3], north: 270, size: [2, 3], end: [1, 1] },
  ])("starts at $start: that corner is (0, 0)", ({ start, north, size, end }) => {
    const [column = 0, row = 0] = start;
    const frame = new MazeFrame(mazeOf(posts, { column, row, heading: "south" }));
    expect(frame.startsInCorner).toBe(true);
    expect([frame.columns, frame.rows]).toEqual(size);
    expect(frame.eighthsOf(north)).toBe(0);
    expect(frame.blockOf({ x: 0, y: 0 })).toEqual({ column, row });
    const last = frame.blockOf({ x: frame.columns - 1, y: frame.rows - 1 });
    expect(Object.values(last)).toEqual(end);
    expect(frame.mapSideOf(0) * 90).toBe(north);
  });

  it("starts elsewhere: (0, 0) is at the bottom left", () => {
    const frame = new MazeFrame(mazeOf(posts, { column: 3, row: 1, heading: "east" }));
    expect(frame.startsInCorner).toBe(false);
    expect(frame.blockOf({ x: 0, y: 0 })).toEqual({ column: 1, row: 3 });
    expect(frame.eighthsOf(0)).toBe(0);
  });

  it("has its goal in the centre", () => {
    const frame = new MazeFrame(mazeOf(posts, { column: 1, row: 3, heading: "north" }));
    const cells = [0, 1, 2].flatMap((x) => [0, 1].map((y) => ({ x, y })));
    expect(cells.filter((cell) => frame.isGoal(cell))).toEqual([
      { x: 1, y: 0 },
      { x: 1, y: 1 },
    ]);
  });

  it("of every preset has its start in cell (0, 0)", () => {
    const elsewhere = mazePresets.filter(({ maze }) => !new MazeFrame(maze).startsInCorner);
    expect(elsewhere.map(({ id }) => id)).toEqual([]);
  });
});
