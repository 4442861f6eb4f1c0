import { describeProblem } from "@corridor/protocol";
import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { parseMaze, type MazeDocument } from "./maze-document.ts";
import { MAX_GOALS } from "./maze-limits.ts";
import {
  clearBlocks,
  rename,
  resize,
  setBlock,
  setStart,
  toggleGoal,
  type MazeEdit,
} from "./maze-edit.ts";
import { arbitraryMaze } from "./testing/arbitrary-maze.ts";

const maze: MazeDocument = {
  format: "corridor/maze",
  version: 1,
  name: "Small",
  blocks: ["....", ".##.", "...."],
  start: { column: 0, row: 0, heading: "east" },
  goals: [{ column: 3, row: 2 }],
};

function edited(edit: MazeEdit): MazeDocument {
  if (!edit.ok) throw new Error(`refused as ${edit.code}`);
  return edit.maze;
}

describe("blocks", () => {
  it("are filled and opened without changing the previous document, start or goals", () => {
    const filled = edited(setBlock(maze, { column: 3, row: 0 }, true));
    expect(filled.blocks).toEqual(["...#", ".##.", "...."]);
    expect(edited(setBlock(filled, { column: 3, row: 0 }, false)).blocks).toEqual(maze.blocks);
    expect(filled.start).toBe(maze.start);
    expect(filled.goals).toBe(maze.goals);
    expect(maze.blocks).toEqual(["....", ".##.", "...."]);
  });

  it("are opened and filled again", () => {
    const opened = edited(setBlock(maze, { column: 1, row: 1 }, false));
    expect(opened.blocks[1]).toBe("..#.");
    expect(edited(setBlock(opened, { column: 1, row: 1 }, true))).toEqual(maze);
  });

  it("remove the goal on their cell", () => {
    expect(edited(setBlock(maze, { column: 3, row: 2 }, true))).toMatchObject({
      blocks: ["....", ".##.", "...#"],
      goals: [],
    });
  });

  it("are all opened by clearBlocks, which retains the start and the goals", () => {
    expect(clearBlocks(maze)).toEqual({ ...maze, blocks: ["....", "....", "...."] });
  });
});

describe("start and goals", () => {
  it("setStart changes the cell and the heading", () => {
    const moved = edited(setStart(maze, { column: 3, row: 2 }, "north"));
    expect(moved.start).toEqual({ column: 3, row: 2, heading: "north" });
  });

  it("toggleGoal adds a goal and removes it again", () => {
    const two = edited(toggleGoal(maze, { column: 0, row: 2 }));
    expect(two.goals).toEqual([
      { column: 3, row: 2 },
      { column: 0, row: 2 },
    ]);
    expect(edited(toggleGoal(two, { column: 0, row: 2 })).goals).toEqual(maze.goals);
  });

  it("toggleGoal removes all goals on a cell", () => {
    const twice = { ...maze, goals: [...maze.goals, ...maze.goals] };
    expect(edited(toggleGoal(twice, { column: 3, row: 2 })).goals).toEqual([]);
  });
});

describe("resize", () => {
  it("adds open cells at the right and bottom", () => {
    expect(edited(resize(maze, 5, 4)).blocks).toEqual([".....", ".##..", ".....", "....."]);
  });

  it("moves a start outside the new size onto an opened cell, and removes goals outside it", () => {
    const from: MazeDocument = { ...maze, start: { column: 3, row: 1, heading: "south" } };
    expect(edited(resize(from, 3, 2))).toEqual({
      ...maze,
      blocks: ["...", ".#."],
      start: { column: 2, row: 1, heading: "south" },
      goals: [],
    });
  });
});

describe("an edit that changes nothing", () => {
  it.each<[string, (from: MazeDocument) => MazeDocument]>([
    ["filling a block", (from) => edited(setBlock(from, { column: 1, row: 1 }, true))],
    ["opening an open cell", (from) => edited(setBlock(from, { column: 0, row: 0 }, false))],
    ["the same start", (from) => edited(setStart(from, { column: 0, row: 0 }, "east"))],
    ["the same size", (from) => edited(resize(from, 4, 3))],
    ["the same name", (from) => edited(rename(from, "Small"))],
  ])("returns the same object: %s", (_, edit) => {
    expect(edit(maze)).toBe(maze);
  });

  it("returns the same object when a maze without blocks is cleared", () => {
    const clear = clearBlocks(maze);
    expect(clearBlocks(clear)).toBe(clear);
  });
});

describe("a refused edit", () => {
  const full: MazeDocument = {
    ...maze,
    goals: Array.from({ length: MAX_GOALS }, () => ({ column: 1, row: 0 })),
  };
  it.each<[string, MazeEdit, string]>([
    ["a block on the start", setBlock(maze, { column: 0, row: 0 }, true), "start-here"],
    ["a block outside", setBlock(maze, { column: 4, row: 0 }, true), "outside"],
    ["opening a cell outside", setBlock(maze, { column: 0, row: -1 }, false), "outside"],
    ["a block left of the maze", setBlock(maze, { column: -1, row: 0 }, true), "outside"],
    ["a block between cells", setBlock(maze, { column: 0.5, row: 0 }, true), "outside"],
    ["the start on a block", setStart(maze, { column: 1, row: 1 }, "east"), "block-here"],
    ["the start outside", setStart(maze, { column: 0, row: 3 }, "east"), "outside"],
    ["a goal on a block", toggleGoal(maze, { column: 2, row: 1 }), "block-here"],
    ["a goal outside", toggleGoal(maze, { column: 9, row: 9 }), "outside"],
    ["goal number 257", toggleGoal(full, { column: 2, row: 0 }), "too-many-goals"],
    ["no columns", resize(maze, 0, 3), "bad-size"],
    ["257 rows", resize(maze, 4, 257), "bad-size"],
    ["half a column", resize(maze, 4.5, 3), "bad-size"],
    ["a size that is no number", resize(maze, Number.NaN, 3), "bad-size"],
    ["a name of 101 characters", rename(maze, "x".repeat(101)), "name-too-long"],
  ])("returns a code: %s", (_, edit, code) => {
    expect(edit).toEqual({ ok: false, code });
  });
});

describe("any sequence of edits", () => {
  const cell = fc.record({
    column: fc.integer({ min: -1, max: 14 }),
    row: fc.integer({ min: -1, max: 14 }),
  });
  const edits = fc.array(
    fc.oneof(
      fc.tuple(cell, fc.boolean()).map(
        ([at, filled]) =>
          (from: MazeDocument) =>
            setBlock(from, at, filled),
      ),
      fc.tuple(cell, fc.constantFrom("north", "east", "south", "west")).map(
        ([at, heading]) =>
          (from: MazeDocument) =>
            setStart(from, at, heading),
      ),
      cell.map((at) => (from: MazeDocument) => toggleGoal(from, at)),
      fc.constant((from: MazeDocument): MazeEdit => ({ ok: true, maze: clearBlocks(from) })),
      fc.tuple(fc.integer({ min: 0, max: 20 }), fc.integer({ min: 0, max: 20 })).map(
        ([columns, rows]) =>
          (from: MazeDocument) =>
            resize(from, columns, rows),
      ),
      fc.string({ maxLength: 120 }).map((name) => (from: MazeDocument) => rename(from, name)),
    ),
    { maxLength: 30 },
  );

  it("results in a valid document and never changes an earlier one", () => {
    fc.assert(
      fc.property(arbitraryMaze, edits, (first, sequence) => {
        const history: { document: MazeDocument; text: string }[] = [];
        let current = first;
        for (const edit of sequence) {
          history.push({ document: current, text: JSON.stringify(current) });
          const result = edit(current);
          if (!result.ok) continue;
          current = result.maze;
          const read = parseMaze(current);
          expect(read.ok ? [] : read.problems.map(describeProblem)).toEqual([]);
        }
        for (const { document, text } of history) expect(JSON.stringify(document)).toBe(text);
      }),
    );
  });
});
