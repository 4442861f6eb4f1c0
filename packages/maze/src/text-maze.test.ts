import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { parseMaze, type Cell, type MazeDocument } from "./maze-document.ts";
import { mazePresets } from "./presets.ts";
import { arbitraryMaze } from "./testing/arbitrary-maze.ts";
import { readTextMaze, writeTextMaze } from "./text-maze.ts";
import { readLines } from "./testing/read-lines.ts";

/** The maze that a drawing represents: each goal once, in reading order. */
function drawn(maze: MazeDocument): MazeDocument {
  const key = ({ column, row }: Cell): number => row * 256 + column;
  const byKey = new Map(maze.goals.map((goal) => [key(goal), goal]));
  return { ...maze, goals: [...byKey.values()].toSorted((a, b) => key(a) - key(b)) };
}

describe("a maze drawn as text", () => {
  it("is read back from its drawing, with any line endings and surrounding empty lines", () => {
    const layout = fc.record({
      end: fc.constantFrom("\n", "\r\n", "\r"),
      around: fc.constantFrom("", "\n", "\n\n"),
    });
    fc.assert(
      fc.property(arbitraryMaze, layout, (maze, { end, around }) => {
        const text = (around + writeTextMaze(maze) + around).replaceAll("\n", end);
        expect(readTextMaze(text, maze.name)).toEqual({ ok: true, value: drawn(maze) });
      }),
    );
  });

  it.each(mazePresets)("$id is read from text with indentation and trailing spaces", ({ maze }) => {
    const text = writeTextMaze(maze)
      .replaceAll(/^(?=.)/gm, "    ")
      .replaceAll("\n", "  \n");
    expect(readTextMaze(`\n   \n${text}\n  `, maze.name)).toEqual({ ok: true, value: maze });
  });

  it.each(mazePresets)("$id is read with spaces for open squares", ({ maze }) => {
    const text = writeTextMaze(maze).replaceAll(".", " ");
    expect(readTextMaze(text, maze.name)).toEqual({ ok: true, value: maze });
  });

  it("accepts all marks and a byte order mark", () => {
    expect(readLines("\uFEFF#Xx█", ">._*", "Gg##")).toEqual([
      "####",
      "....",
      "..##",
      "0,1 east",
      "3,1",
      "0,2",
      "1,2",
    ]);
  });

  it.each([
    { lines: ["#.#", ".S."], heading: "north" },
    { lines: ["#S.", "..."], heading: "east" },
    { lines: ["#S#", "#.#"], heading: "south" },
    { lines: [".S#", "###"], heading: "west" },
    { lines: ["#S#", "###", "..."], heading: "north" },
  ])("sets the heading of an S to its first open direction: $heading", ({ lines, heading }) => {
    expect(readLines(...lines)).toContainEqual(expect.stringContaining(heading));
  });

  it("pads shorter lines with open squares if spaces are open squares", () => {
    expect(readLines("#####", "#S", "#   #")).toEqual(["#####", "#....", "#...#", "1,1 east"]);
    expect(readLines("####", "#S  ", "#   ")).toEqual(["####", "#...", "#...", "1,1 east"]);
  });

  it.each([
    {
      defect: "an unknown mark",
      lines: ["###", "#?S"],
      problem: 'line 2, column 2: "?", # for a block',
    },
    { defect: "a tab", lines: ["S..", ".\t."], problem: "line 2, column 2: a tab, # for" },
    {
      defect: "a space among dots",
      lines: ["  S..", "  . ."],
      problem: "line 2, column 4: a space, . as",
    },
    {
      defect: "a short row",
      lines: ["", "S..", ".."],
      problem: "line 3: 2 squares, 3 squares, as in line 2",
    },
    {
      defect: "an empty row",
      lines: ["S..", "", "..."],
      problem: "line 2: 0 squares, 3 squares, as in",
    },
    {
      defect: "an empty row with spaces",
      lines: ["# #", "", "#S"],
      problem: "line 2: an empty line, a row",
    },
    { defect: "no start", lines: ["...", "###"], problem: "start: none, one S, or one of ^ > v <" },
    {
      defect: "two starts",
      lines: ["S..", "..>"],
      problem:
        "line 2, column 3: a second start, one start in all; the first is in line 1, column 1",
    },
    {
      defect: "no drawing",
      lines: ["Dear all, the maze"],
      problem: 'line 1: "Dear all, the maze", a row of',
    },
    {
      defect: "walls as bytes of another number of cells",
      lines: ["\u000E\u000A\u000B\u0006".repeat(25)],
      problem: ": data that is not text, a drawing, a list of cells, or 256 bytes of walls",
    },
    { defect: "nothing", lines: ["", "  "], problem: ": nothing, a maze, line by line" },
    {
      defect: "too wide",
      lines: [`S${".".repeat(256)}`],
      problem: "line 1: 257 squares, at most 256",
    },
    {
      defect: "too tall",
      lines: ["S.", ...Array.from({ length: 300 }, () => "..")],
      problem: "line 257: 301 rows, at most 256 rows",
    },
    {
      defect: "too long",
      lines: ["S".repeat(262_145)],
      problem: ": 262145 characters, at most 262144",
    },
    {
      defect: "too many goals",
      lines: ["S", "G".repeat(255), "GG"].map((line) => line.padEnd(255, "#")),
      problem: "line 3, column 2: one more goal, at most 256 goals",
    },
  ])("is rejected for $defect, with position, found and expected", ({ lines, problem }) => {
    expect(readLines(...lines)).toEqual([expect.stringContaining(problem)]);
  });
});

describe("any text", () => {
  const characters = fc.string({
    unit: fc.constantFrom(...Array.from("#.X _\nSG^>v<*o+-|▲\t?01\r")),
    maxLength: 300,
  });

  it("is a valid maze or rejected with 1 to 20 problems", () => {
    fc.assert(
      fc.property(
        fc.oneof(characters, fc.string({ unit: "binary" })),
        fc.string(),
        (text, name) => {
          const result = readTextMaze(text, name.repeat(40));
          if (result.ok) return parseMaze(result.value).ok;
          return result.problems.length >= 1 && result.problems.length <= 20;
        },
      ),
      { numRuns: 2000 },
    );
  });
});
