import fc from "fast-check";
import { describe, expect, it } from "vitest";
import type { MazeDocument } from "../maze-document.ts";
import { readTextMaze } from "../text-maze.ts";
import { isBinaryMaze } from "./cell-bytes.ts";
import { isContestText, readBinaryMaze } from "./read-contest-maze.ts";
import { anySides, arbitraryContest, arbitraryDrawn, SAMPLE } from "./testing/sample-contest.ts";
import { writeContestMaze } from "./write-contest-maze.ts";

/** Writes and reads a maze. @param change what happens to the text in between */
function throughText(
  maze: MazeDocument,
  format: "map" | "num",
  change: (text: string) => string = (text) => text,
): MazeDocument {
  const written = writeContestMaze(maze, format);
  if (!written.ok || typeof written.value !== "string") throw new Error("expected a text");
  const text = change(written.value);
  expect(isContestText(text)).toBe(true);
  const read = readTextMaze(text, maze.name);
  if (!read.ok) throw new Error(JSON.stringify(read.problems));
  return read.value;
}

function sample(): MazeDocument {
  const read = readTextMaze(SAMPLE, "Sample");
  if (!read.ok) throw new Error(JSON.stringify(read.problems));
  return read.value;
}

const drawn = fc.oneof(arbitraryDrawn, arbitraryContest({ sides: anySides, hasUsualStart: false }));
const square = fc.constant({ columns: 16, rows: 16 });

describe("a contest maze that is saved and opened", () => {
  it("is the same as a drawing, with any characters, line ends and text around it", () => {
    const layout = fc.record({
      post: fc.constantFrom("o", "+", "*", "."),
      walls: fc.constantFrom("-|", "=!", "~:"),
      end: fc.constantFrom("\n", "\r\n", "\r"),
      indent: fc.constantFrom("", "  "),
      after: fc.constantFrom("", "\n", "\n\nFinal 2019\n  by Anna\n", "Final\n", "\u001A"),
    });
    fc.assert(
      fc.property(drawn, layout, (maze, { post, walls, end, indent, after }) => {
        const [across = "", down = ""] = walls;
        const redrawn = (text: string): string =>
          (text + after)
            .replaceAll(/^(?=.)/gm, indent)
            .replaceAll(/o(?=[o -]|$)/gm, post)
            .replaceAll("-", across)
            .replaceAll("|", down)
            .replaceAll("\n", end);
        expect(throughText(maze, "map", redrawn)).toEqual(maze);
      }),
    );
  });

  it("is the same as a list, with lines in any order", () => {
    const maze = arbitraryContest({ sides: anySides, hasUsualStart: false });
    fc.assert(
      fc.property(maze, fc.boolean(), (each, isReversed) => {
        const lines = (text: string): string =>
          isReversed ? text.trimEnd().split("\n").toReversed().join("\r\n") : text;
        expect(throughText(each, "num", lines)).toEqual(each);
      }),
    );
  });

  it("is the same as a binary file", () => {
    fc.assert(
      fc.property(arbitraryContest({ sides: square, hasUsualStart: false }), (maze) => {
        const written = writeContestMaze(maze, "maz");
        if (!written.ok || typeof written.value === "string") throw new Error("expected bytes");
        expect(isBinaryMaze(written.value)).toBe(true);
        expect(readBinaryMaze(written.value, maze.name)).toEqual({ ok: true, value: maze });
      }),
    );
  });

  it("is the same in the largest size", () => {
    const sides = fc.constant({ columns: 127, rows: 127 });
    fc.assert(
      fc.property(arbitraryContest({ sides, hasUsualStart: true }), (maze) => {
        expect(throughText(maze, "map")).toEqual(maze);
        expect(throughText(maze, "num")).toEqual(maze);
      }),
      { numRuns: 3 },
    );
  });

  it("is drawn as contests do", () => {
    expect(writeContestMaze(sample(), "map")).toEqual({ ok: true, value: SAMPLE });
  });
});

describe("a maze that a format cannot store", () => {
  const maze = sample();
  const blocksWith = (row: number, text: string): string[] => maze.blocks.with(row, text);
  it.each([
    {
      defect: "an even number of columns",
      change: { blocks: maze.blocks.map((row) => row.slice(1)) },
      formats: ["map", "num", "maz"],
      code: "no-contest-maze",
    },
    {
      defect: "a block in a cell",
      change: { blocks: blocksWith(1, "#.#...#.....#") },
      formats: ["map", "num", "maz"],
      code: null,
    },
    {
      defect: "a filled cell",
      change: { blocks: blocksWith(1, "###...#.....#") },
      formats: ["map", "num", "maz"],
      code: "no-contest-maze",
    },
    {
      defect: "a start between cells",
      change: { start: { column: 1, row: 2, heading: "north" as const } },
      formats: ["map", "num", "maz"],
      code: "no-contest-maze",
    },
    {
      defect: "a goal between cells",
      change: { goals: [{ column: 6, row: 5 }] },
      formats: ["map", "num", "maz"],
      code: "no-contest-maze",
    },
    {
      defect: "a gap in the outer wall",
      change: { blocks: blocksWith(1, "......#.....#") },
      formats: ["map", "num", "maz"],
      code: "outer-wall",
    },
    { defect: "no goal", change: { goals: [] }, formats: ["map"], code: "no-goal" },
    { defect: "no goal", change: { goals: [] }, formats: ["num", "maz"], code: "goals" },
    {
      defect: "another start",
      change: { start: { column: 3, row: 1, heading: "north" as const } },
      formats: ["num", "maz"],
      code: "start",
    },
    {
      defect: "another heading",
      change: { start: { ...maze.start, heading: "east" as const } },
      formats: ["num", "maz"],
      code: "start",
    },
    {
      defect: "a missing post",
      change: { blocks: blocksWith(6, "#.###...#.###".replace(/^#\.#/, "#..")) },
      formats: ["num", "maz"],
      code: "posts",
    },
    { defect: "another size", change: {}, formats: ["maz"], code: "sides" },
  ] as const)("is refused for $defect as $formats", ({ change, formats, code }) => {
    for (const format of formats) {
      const written = writeContestMaze({ ...maze, ...change } as MazeDocument, format);
      const found = written.ok ? null : written.refusal.code;
      expect(found).toBe(code === null && format === "maz" ? "sides" : code);
      if (written.ok) continue;
      expect(written.refusal.problem.found).not.toBe("");
      expect(written.refusal.problem.expected).not.toBe("");
    }
  });
});
