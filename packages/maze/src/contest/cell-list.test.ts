import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { parseMaze } from "../maze-document.ts";
import { readTextMaze } from "../text-maze.ts";
import { readLines } from "../testing/read-lines.ts";

describe("a list of cells", () => {
  it("has the start at the bottom left and the goal in the centre", () => {
    expect(readLines("\r\n0 0 0 1 1 1\r\n\r\n 0\t1 1 0 0 1\r\n1 1 1 1 1 0\n1 0 1 1 1 1\n")).toEqual(
      ["#####", "#...#", "#.###", "#.#.#", "#####", "1,3 north", "1,1", "3,1", "1,3", "3,3"],
    );
  });

  it.each([
    {
      defect: "a missing number",
      text: "0 0 1 1 1 1\n0 1 1 1 1",
      problems: [
        'line 2: "0 1 1 1 1", X Y N E S W: a cell from 0 to 126, and 1 or 0 for its walls',
      ],
    },
    {
      defect: "another wall than 1 and 0",
      text: "0 0 1 1 1 2",
      problems: [
        'line 1: "0 0 1 1 1 2", X Y N E S W: a cell from 0 to 126, and 1 or 0 for its walls',
      ],
    },
    {
      defect: "a cell beyond the largest maze",
      text: "127 0 1 1 1 1",
      problems: [
        'line 1: "127 0 1 1 1 1", X Y N E S W: a cell from 0 to 126, and 1 or 0 for its walls',
      ],
    },
    {
      defect: "text after the list",
      text: "0 0 1 1 1 1\nFinal",
      problems: ['line 2: "Final", X Y N E S W: a cell from 0 to 126, and 1 or 0 for its walls'],
    },
    {
      defect: "a repeated cell",
      text: "\n0 0 1 1 1 1\n0 0 1 1 1 1",
      problems: ["line 3: cell 0 0 again, each cell once; it is in line 2 already"],
    },
    {
      defect: "a missing cell",
      text: "0 0 1 1 1 1\n1 1 1 1 1 1\n1 0 1 1 1 1",
      problems: ["line 3: no line for cell 0 1, a line for each of 2 x 2 cells"],
    },
    {
      defect: "a gap in the outer wall",
      text: "0 0 1 0 1 1",
      problems: ["line 1: no wall in the east, the outer wall"],
    },
    {
      defect: "a wall from one side",
      text: "1 0 1 1 1 1\n0 0 1 0 1 1",
      problems: ["line 2: no wall in the east, a wall, as cell 1 0 has on its side"],
    },
  ])("is rejected for $defect, with line, found and expected", ({ text, problems }) => {
    expect(readLines(text)).toEqual(problems);
  });

  it("reports at most 20 problems", () => {
    expect(readLines("0 0 1 1 1 1\n126 126 1 1 1 1")).toHaveLength(20);
    expect(readLines(`0 0 1 1 1 1${"\nx".repeat(99_999)}`)).toHaveLength(20);
  });

  it("is a valid maze or rejected, whatever it contains", () => {
    const number = fc.constantFrom("0", "1", "2", "126", "99999999999999999999", "-1", "");
    const line = fc.array(number, { minLength: 5, maxLength: 7 }).map((each) => each.join(" "));
    fc.assert(
      fc.property(fc.array(line, { maxLength: 9 }), (lines) => {
        const result = readTextMaze(lines.join("\n"), "");
        if (result.ok) return parseMaze(result.value).ok;
        return result.problems.length >= 1 && result.problems.length <= 20;
      }),
    );
  });
});
