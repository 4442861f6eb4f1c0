import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { parseMaze, type Cell, type MazeDocument } from "./maze-document.ts";
import { mazePresets } from "./presets.ts";
import { arbitraryMaze } from "./testing/arbitrary-maze.ts";
import { readTextMaze, writeTextMaze } from "./text-maze.ts";

/** Goals as a drawing has them: in reading order, each once. */
function drawn(maze: MazeDocument): MazeDocument {
  const key = ({ column, row }: Cell): number => row * 256 + column;
  const byKey = new Map(maze.goals.map((goal) => [key(goal), goal]));
  return { ...maze, goals: [...byKey.values()].toSorted((a, b) => key(a) - key(b)) };
}

function read(...lines: string[]): unknown {
  const result = readTextMaze(lines.join("\n"), "Drawn");
  if (!result.ok) {
    return result.problems.map((each) => `${each.path}: ${each.found}, ${each.expected}`);
  }
  const { blocks, start, goals } = result.value;
  const to = goals.map(({ column, row }) => `${column},${row}`);
  return [...blocks, `${start.column},${start.row} ${start.heading}`, ...to];
}

describe("a maze that was drawn as text", () => {
  it("comes back from its own drawing, with any line ends, indentation and spaces behind", () => {
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

  it.each(mazePresets)("$id is read from a mail that indents it and adds spaces", ({ maze }) => {
    const text = writeTextMaze(maze)
      .replaceAll(/^(?=.)/gm, "    ")
      .replaceAll("\n", "  \n");
    expect(readTextMaze(`\n   \n${text}\n  `, maze.name)).toEqual({ ok: true, value: maze });
  });

  it.each(mazePresets)("$id is read with spaces for open squares", ({ maze }) => {
    const text = writeTextMaze(maze).replaceAll(".", " ");
    expect(readTextMaze(text, maze.name)).toEqual({ ok: true, value: maze });
  });

  it("takes all of its marks, and a mark order mark", () => {
    expect(read("\uFEFF#Xx█", ">._*", "Gg##")).toEqual([
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
  ])("turns an S to its first open way, from north on: $heading", ({ lines, heading }) => {
    expect(read(...lines)).toContainEqual(expect.stringContaining(heading));
  });

  it("ends shorter lines in open squares where those are spaces", () => {
    expect(read("#####", "#S", "#   #")).toEqual(["#####", "#....", "#...#", "1,1 east"]);
    expect(read("####", "#S  ", "#   ")).toEqual(["####", "#...", "#...", "1,1 east"]);
  });

  it.each([
    {
      is: "a mark of its own",
      lines: ["###", "#?S"],
      says: 'line 2, column 2: "?", # for a block',
    },
    { is: "a tab", lines: ["S..", ".\t."], says: "line 2, column 2: a tab, # for" },
    {
      is: "a space among dots",
      lines: ["  S..", "  . ."],
      says: "line 2, column 4: a space, . as",
    },
    {
      is: "a short row",
      lines: ["", "S..", ".."],
      says: "line 3: 2 squares, 3 squares, as in line 2",
    },
    { is: "an empty row", lines: ["S..", "", "..."], says: "line 2: 0 squares, 3 squares, as in" },
    {
      is: "an empty row with spaces",
      lines: ["# #", "", "#S"],
      says: "line 2: an empty line, a row",
    },
    { is: "no start", lines: ["...", "###"], says: "start: none, one S, or one of ^ > v <" },
    {
      is: "two starts",
      lines: ["S..", "..>"],
      says: "line 2, column 3: a second start, one start in all; the first is in line 1, column 1",
    },
    {
      is: "no drawing",
      lines: ["Dear all, the maze"],
      says: 'line 1: "Dear all, the maze", a row of',
    },
    { is: "nothing", lines: ["", "  "], says: ": nothing, a maze, line by line" },
    { is: "too wide", lines: [`S${".".repeat(256)}`], says: "line 1: 257 squares, at most 256" },
    {
      is: "too tall",
      lines: ["S.", ...Array.from({ length: 300 }, () => "..")],
      says: "line 257: 301 rows, at most 256 rows",
    },
    { is: "too long", lines: ["S".repeat(262_145)], says: ": 262145 characters, at most 262144" },
    {
      is: "too many goals",
      lines: ["S", "G".repeat(255), "GG"].map((line) => line.padEnd(255, "#")),
      says: "line 3, column 2: one more goal, at most 256 goals",
    },
  ])("is refused where it has $is, by place, found and expected", ({ lines, says }) => {
    expect(read(...lines)).toEqual([expect.stringContaining(says)]);
  });
});

describe("a micromouse maze", () => {
  it("becomes blocks for its walls and posts", () => {
    const lines = [
      "o---o---o---o",
      "|       | G |",
      "o   o---o   o",
      "| S |        ",
      "+---+---+---+",
    ];
    const maze = ["#######", "#...#.#", "#.###.#", "#.#....", "#######", "1,3 north", "5,1"];
    expect(read(...lines)).toEqual(maze);
    // Editors drop spaces at the end, mails put some in front.
    expect(read(...lines.map((line) => `  ${line.trimEnd()}`))).toEqual(maze);
  });

  it("has open space where a post is left out", () => {
    expect(read("o---o---o", "| >     |", "o       o", "|   |   |", "o---o---o")).toEqual([
      "#####",
      "#...#",
      "#...#",
      "#.#.#",
      "#####",
      "1,1 east",
    ]);
  });

  it.each([
    { is: "half a wall", at: 2, line: "o-- o   o", says: 'line 3, column 2: "-- ", a wall, ---' },
    { is: "a wrong post", at: 2, line: "o---x   o", says: 'line 3, column 5: "x", a post: o or +' },
    { is: "a wrong side", at: 1, line: "| S :   |", says: 'line 2, column 5: ":", a wall, |, or' },
    { is: "a number", at: 1, line: "| S | 12|", says: 'line 2, column 7: "12", three spaces, S' },
    {
      is: "a longer line",
      at: 3,
      line: "|   |   | <",
      says: "line 4: 11 characters, at most 9, as",
    },
    { is: "a cut first line", at: 0, line: "o---o--", says: "line 1: 7 characters, 1 to 127" },
    { is: "a line too many", at: 4, line: "o---o---o\n|   |", says: "line 6: 6 lines, an odd" },
  ])("is refused with $is, by place, found and expected", ({ at, line, says }) => {
    const lines = ["o---o---o", "| S     |", "o   o   o", "|   |   |", "o---o---o"];
    lines[at] = line;
    expect(read(...lines)).toEqual([expect.stringContaining(says)]);
  });

  it("may have 127 by 127 squares and no more", () => {
    const text = (side: number): string => {
      const posts = `${"o---".repeat(side)}o`;
      const squares = `| S ${"    ".repeat(side - 1)}|`;
      const plain = `|${"   |".repeat(side)}`;
      const rows = Array.from({ length: side }, (_, row) => [row === 0 ? squares : plain, posts]);
      return [posts, ...rows.flat()].join("\n");
    };
    expect(readTextMaze(text(127), "").ok).toBe(true);
    expect(readTextMaze(text(128), "").ok).toBe(false);
  });

  it("is refused, however many lines it has", () => {
    expect(read("o".concat("\no".repeat(131_000)))).toEqual([
      "line 1: 1 characters, 1 to 127 squares: a post every 4 characters, o---o---o",
    ]);
  });
});

describe("any text", () => {
  const signs = fc.string({
    unit: fc.constantFrom(...Array.from("#.X _\nSG^>v<*o+-|▲\t?1\r")),
    maxLength: 300,
  });

  it("is a legal maze or refused with 1 to 20 problems", () => {
    fc.assert(
      fc.property(fc.oneof(signs, fc.string({ unit: "binary" })), fc.string(), (text, name) => {
        const result = readTextMaze(text, name.repeat(40));
        if (result.ok) return parseMaze(result.value).ok;
        return result.problems.length >= 1 && result.problems.length <= 20;
      }),
      { numRuns: 2000 },
    );
  });
});
