import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { dailyMaze, dayAfter, dayNumber, type Day } from "./daily.ts";
import { countOpenCells, distancesFromStart, UNREACHABLE } from "./flood-fill.ts";
import { parseMaze } from "./maze-document.ts";

const DAY_MS = 86_400_000;
const anyNumber = fc.integer({ min: -30_000, max: 100_000 });

/** Date of a day number, computed with the built-in `Date`. */
function byEngine(number: number): Day {
  const date = new Date(number * DAY_MS);
  return { year: date.getUTCFullYear(), month: date.getUTCMonth() + 1, day: date.getUTCDate() };
}

describe("the calendar", () => {
  it("matches the built-in Date", () => {
    fc.assert(
      fc.property(anyNumber, fc.integer({ min: -800, max: 800 }), (number, days) => {
        expect(dayNumber(byEngine(number))).toBe(number);
        expect(dayAfter(byEngine(number), days)).toEqual(byEngine(number + days));
      }),
    );
  });

  it("rejects a date that does not exist", () => {
    expect(() => dayNumber({ year: 2026, month: 2, day: 29 })).toThrow(RangeError);
    expect(() => dayNumber({ year: 2028, month: 13, day: 1 })).toThrow(RangeError);
    expect(dayNumber({ year: 2028, month: 2, day: 29 })).toBe(21_243);
  });
});

describe("the daily maze", () => {
  it("is a valid maze with a reachable goal on every day", () => {
    fc.assert(
      fc.property(anyNumber, (number) => {
        const maze = dailyMaze(byEngine(number), "Day");
        expect(parseMaze(maze).ok).toBe(true);
        const distances = distancesFromStart(maze);
        const reached = distances.filter((each) => each !== UNREACHABLE).length;
        expect(reached).toBe(countOpenCells(maze));
        expect(maze.goals).toHaveLength(1);
      }),
      { numRuns: 50 },
    );
  });

  it("differs from the maze of the previous day", () => {
    fc.assert(
      fc.property(anyNumber, (number) => {
        const today = dailyMaze(byEngine(number), "Day");
        expect(today.blocks).not.toEqual(dailyMaze(byEngine(number - 1), "Day").blocks);
      }),
      { numRuns: 50 },
    );
  });

  it("stays the same across releases, because links and results refer to it", () => {
    const maze = dailyMaze({ year: 2026, month: 1, day: 5 }, "Maze of 5 January 2026");
    expect(maze).toMatchInlineSnapshot(`
      {
        "blocks": [
          "#########",
          "#.......#",
          "#.###.#.#",
          "#.....#.#",
          "#######.#",
          "#.....#.#",
          "#.###.#.#",
          "#...#...#",
          "#########",
        ],
        "format": "corridor/maze",
        "goals": [
          {
            "column": 3,
            "row": 7,
          },
        ],
        "name": "Maze of 5 January 2026",
        "start": {
          "column": 1,
          "heading": "south",
          "row": 1,
        },
        "version": 1,
      }
    `);
  });

  it("grows from Monday to Sunday", () => {
    const monday = { year: 2026, month: 1, day: 5 };
    const sizes = Array.from(
      { length: 8 },
      (_, at) => dailyMaze(dayAfter(monday, at), "").blocks.length,
    );
    expect(sizes).toEqual([9, 11, 11, 13, 13, 15, 17, 9]);
  });
});
