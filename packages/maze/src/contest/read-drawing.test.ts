import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { parseMaze } from "../maze-document.ts";
import { readTextMaze } from "../text-maze.ts";
import { startsDrawing } from "./read-drawing.ts";
import { SAMPLE } from "./testing/sample-contest.ts";
import { readLines } from "../testing/read-lines.ts";

describe("a drawing of posts and walls", () => {
  it("is read with a block for each wall and post", () => {
    const lines = [
      "o---o---o---o",
      "|       | G |",
      "o   o---o   o",
      "| S |        ",
      "+---+---+---+",
    ];
    const maze = ["#######", "#...#.#", "#.###.#", "#.#....", "#######", "1,3 north", "5,1"];
    expect(readLines(...lines)).toEqual(maze);
    // Editors strip trailing spaces, and mail clients indent quoted text.
    expect(readLines(...lines.map((line) => `  ${line.trimEnd()}`))).toEqual(maze);
  });

  it("has the start at the bottom left and the goal in the centre, unless marks say otherwise", () => {
    const lines = (inside: string): string[] => [
      "o---o---o---o",
      `| ${inside} |`,
      "o   o   o   o",
      "|           |",
      "o---o---o---o",
    ];
    const blocks = ["#######", "#.....#", "#.#.#.#", "#.....#", "#######"];
    expect(readLines(...lines("         "))).toEqual([...blocks, "1,3 north", "3,1", "3,3"]);
    expect(readLines(...lines("S        "))).toEqual([...blocks, "1,1 east", "3,1", "3,3"]);
    expect(readLines(...lines("        G"))).toEqual([...blocks, "1,3 north", "5,1"]);
  });

  it("has any characters for posts and walls", () => {
    const maze = ["#####", "#.#.#", "#.###", "#...#", "#####", "1,3 north", "3,1"];
    expect(readLines("+===+===+", "!   I G !", "+   *===+", "! S     !", "+===*===+")).toEqual(
      maze,
    );
    expect(readLines("---------", "|   | G |", "|   -----", "| S     |", "---------")).toEqual(
      maze,
    );
    // Simulators read only the middle of a wall.
    expect(readLines("o---o---o", "|   | G |", "o   o - o", "| S     |", "o---o-- o")).toEqual(
      maze,
    );
  });

  it.each([
    ["o---o---o", true],
    ["  + - + -", true],
    ["*===*", true],
    ["#---#---#", true],
    [".---.", true],
    ["---------", true],
    ["#########", false],
    ["#...#...#", false],
    ["x---x--x", false],
    ["#S---G--#", false],
    ["", false],
  ])("differs from a drawing of squares in its first line: %s", (line, expected) => {
    expect(startsDrawing(line)).toBe(expected);
  });

  it("is open where a post is missing", () => {
    expect(readLines("o---o---o", "| >     |", "o       o", "| G |   |", "o---o---o")).toEqual([
      "#####",
      "#...#",
      "#...#",
      "#.#.#",
      "#####",
      "1,1 east",
      "1,3",
    ]);
  });

  it.each([
    ["text", ["", "Final of 2019, 16 x 16", "o---o"]],
    ["text at once", ["Final"]],
    ["indented text", ["", "  by Anna", "  of Bern"]],
    ["the end of a text in DOS", ["\u001A"]],
  ])("ends before %s", (_, after) => {
    const plain = SAMPLE.trimEnd().split("\n");
    expect(readLines(...plain, ...after)).toEqual(readLines(...plain));
  });

  it.each([
    {
      defect: "half a wall",
      at: 2,
      line: "o-  o   o",
      problem: 'line 3, column 2: "-  ", a wall, ---',
    },
    {
      defect: "shifted characters",
      at: 2,
      line: "o--o    o",
      problem: 'line 3, column 2: "--o", a wall, ---',
    },
    {
      defect: "a number",
      at: 1,
      line: "| S | 12|",
      problem: 'line 2, column 7: "12", three spaces, S',
    },
    {
      defect: "a longer line",
      at: 3,
      line: "|   |   | <",
      problem: "line 4: 11 characters, at most 9, as",
    },
    {
      defect: "a truncated first line",
      at: 0,
      line: "o---o--",
      problem: "line 1: 7 characters, 1 to 127",
    },
    {
      defect: "an extra line",
      at: 4,
      line: "o---o---o\n|   |",
      problem: "line 7: nothing, a line of posts",
    },
    {
      defect: "a line that is no line of posts",
      at: 4,
      line: "x---x---x",
      problem: 'line 5: "x---x---x", a line of posts',
    },
    {
      defect: "text in the maze",
      at: 3,
      line: "and then",
      problem: 'line 4: "and then", a line of cells, such as |   |, or a closed outer wall above',
    },
  ])("is rejected for $defect, with position, found and expected", ({ at, line, problem }) => {
    const lines = ["o---o---o", "| S     |", "o   o   o", "|   |   |", "o---o---o"];
    lines[at] = line;
    expect(readLines(...lines)).toEqual([expect.stringContaining(problem)]);
  });

  it("is limited to 127 x 127 cells", () => {
    const text = (side: number): string => {
      const posts = `${"o---".repeat(side)}o`;
      const cells = `| S ${"    ".repeat(side - 1)}|`;
      const plain = `|${"   |".repeat(side)}`;
      const rows = Array.from({ length: side }, (_, row) => [row === 0 ? cells : plain, posts]);
      return [posts, ...rows.flat()].join("\n");
    };
    expect(readTextMaze(text(127), "").ok).toBe(true);
    expect(readTextMaze(text(128), "").ok).toBe(false);
  });

  it("is rejected with one problem when it has 131,001 lines", () => {
    expect(readLines("o".concat("\no".repeat(131_000)))).toEqual([
      "line 1: 1 characters, 1 to 127 cells: a post every 4 characters, o---o---o",
    ]);
  });
});

describe("any drawing", () => {
  it("is a valid maze or rejected with 1 to 20 problems", () => {
    const line = fc.string({ unit: fc.constantFrom(...Array.from("o+-| SGx\t")), maxLength: 9 });
    const posts = fc.constantFrom("o---o---o", "o   o---o", "+---o---+", "o-- o   o", "");
    const cells = fc.constantFrom("|   |   |", "| S   G |", "|       !", "    |", "");
    const lines = fc.array(fc.oneof(line, posts, cells), { maxLength: 9 });
    fc.assert(
      fc.property(lines, (rest) => {
        const result = readTextMaze(["o---o---o", ...rest].join("\n"), "");
        if (result.ok) return parseMaze(result.value).ok;
        return result.problems.length >= 1 && result.problems.length <= 20;
      }),
      { numRuns: 2000 },
    );
  });
});
