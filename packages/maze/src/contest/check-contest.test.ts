import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { distancesFromStart } from "../flood-fill.ts";
import { sizeOf } from "../maze-cells.ts";
import type { MazeDocument } from "../maze-document.ts";
import { readTextMaze } from "../text-maze.ts";
import { checkContest, type ContestCheck } from "./check-contest.ts";
import { contestMazeOf } from "./contest-maze.ts";
import { anySides, arbitraryContest, arbitraryDrawn, SAMPLE } from "./testing/sample-contest.ts";

function mazeOf(text: string): MazeDocument {
  const read = readTextMaze(text, "");
  if (!read.ok) throw new Error(JSON.stringify(read.problems));
  return read.value;
}

function check(maze: MazeDocument): ContestCheck {
  const contest = contestMazeOf(maze);
  if (!contest.ok) throw new Error(contest.refusal.problem.expected);
  return checkContest(contest.value);
}

/** The sample with changed lines. */
function changed(changes: Record<number, string>): string {
  const lines = SAMPLE.split("\n");
  for (const [line, text] of Object.entries(changes)) lines[Number(line)] = text;
  return lines.join("\n");
}

describe("the check of a contest maze", () => {
  it("finds the shortest path and no broken rule in a good maze", () => {
    const { shortestPath, broken } = check(mazeOf(SAMPLE));
    expect(shortestPath).toBe(10);
    expect(broken).toEqual([]);
  });

  it.each([
    { rule: "outer-wall", count: null, lines: { 1: "|           |" } },
    { rule: "missing-posts", count: 1, lines: { 6: "o   o---o       o   o---o" } },
    { rule: "unreachable-cells", count: 1, lines: { 1: "|           |       |   |" } },
    { rule: "start-walls", count: 2, lines: { 11: "| S                     |" } },
    { rule: "goal-entrances", count: 2, lines: { 7: "|       | G   G         |" } },
    { rule: "goal-entrances", count: 0, lines: { 4: "o   o   o---o---o---o   o" } },
    { rule: "centre-post", count: null, lines: { 5: "|       | G | G |       |" } },
    { rule: "bare-posts", count: 1, lines: { 3: "|               |       |" } },
    { rule: "wall-follower", count: null, lines: { 4: "o---o---o---o   o---o   o" } },
  ])("finds the broken rule $rule", ({ rule, count, lines }) => {
    expect(check(mazeOf(changed(lines as Record<number, string>))).broken).toContainEqual({
      rule,
      count,
    });
  });

  it("shows the island around the goal and the loop of a wall follower", () => {
    const maze = mazeOf(SAMPLE);
    const miss = check(maze).wallFollowerMiss;
    const marked = maze.blocks.map((row) => row.split("").map(() => " "));
    for (const { column, row } of miss?.island ?? []) {
      const cells = marked[row];
      if (cells !== undefined) cells[column] = "#";
    }
    expect(marked.map((row) => row.join("").trimEnd())).toMatchInlineSnapshot(`
      [
        "",
        "",
        "        #",
        "        #",
        "    ### ###",
        "    #   #",
        "  ###   #",
        "    #   #",
        "    ##### #",
        "    #     #",
        "    #######",
        "",
        "",
      ]
    `);
    expect(miss?.loop[0]).toEqual({ column: 1, row: 11 });
    expect(miss?.loop.at(-1)).toEqual({ column: 1, row: 11 });
  });

  it("shows no island around a goal that stands free", () => {
    const free = `${"o---".repeat(5)}o\n${`|${"    ".repeat(4)}   |\n${"o   ".repeat(5)}o\n`.repeat(4)}| S |${"    ".repeat(3)}   |\n${"o---".repeat(5)}o`;
    const { wallFollowerMiss, broken } = check(mazeOf(free));
    expect(wallFollowerMiss?.island).toEqual([]);
    expect(wallFollowerMiss?.loop.length).toBeGreaterThan(15);
    expect(broken.map(({ rule }) => rule)).not.toContain("wall-follower");
  });

  it("does not blame wall followers for a goal that no path leads to", () => {
    const { shortestPath, wallFollowerMiss } = check(
      mazeOf("o---o---o---o\n|   |   |   |\no   o---o   o\n| S |   |   |\no---o---o---o"),
    );
    expect(shortestPath).toBeNull();
    expect(wallFollowerMiss).toBeNull();
  });

  it("holds for any maze of posts and walls", () => {
    const any = fc.oneof(
      arbitraryDrawn,
      arbitraryContest({ sides: anySides, hasUsualStart: true }),
    );
    fc.assert(
      fc.property(any, (maze) => {
        const { shortestPath, broken, wallFollowerMiss } = check(maze);
        const distances = distancesFromStart(maze);
        const { columns } = sizeOf(maze);
        const reached = maze.goals
          .map(({ column, row }) => distances[row * columns + column] ?? -1)
          .filter((distance) => distance >= 0);
        expect(shortestPath).toBe(reached.length === 0 ? null : Math.min(...reached) / 2);
        const isFollowed = broken.some(({ rule }) => rule === "wall-follower");
        expect(wallFollowerMiss === null).toBe(isFollowed || shortestPath === null);
        if (wallFollowerMiss === null) return;
        const goals = new Set(maze.goals.map(({ column, row }) => `${column} ${row}`));
        for (const { column, row } of wallFollowerMiss.loop) {
          expect(goals.has(`${column} ${row}`)).toBe(false);
        }
        for (const { column, row } of wallFollowerMiss.island) {
          expect(maze.blocks[row]?.[column]).toBe("#");
          expect(column * row).toBeGreaterThan(0);
        }
      }),
    );
  });
});
