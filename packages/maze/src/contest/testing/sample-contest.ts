/** Contest mazes of our own, and random ones. */
import fc from "fast-check";
import type { MazeDocument } from "../../maze-document.ts";
import { BLOCK, headingNames, OPEN } from "../../maze-limits.ts";
import { createRandom } from "../../random.ts";
import { cellOf, contestGoals, type ContestSize, contestStart } from "../contest-cells.ts";

/** Keeps every rule of contests: no wall follower reaches its goal, which is 10 cells away. */
export const SAMPLE = `${String.raw`
o---o---o---o---o---o---o
|           |           |
o   o---o---o   o   o---o
|   |           |       |
o   o   o---o   o---o   o
|       | G   G |       |
o   o---o   o   o   o---o
|       | G   G |       |
o---o   o---o---o   o   o
|       |           |   |
o   o   o---o---o---o   o
| S |                   |
o---o---o---o---o---o---o
`.trim()}\n`;

interface Options {
  sides: fc.Arbitrary<ContestSize>;
  /** whether the start has three walls and is open to the north */
  hasUsualStart: boolean;
}

/** Random walls between all posts, with the start and the goals of contests. */
export function arbitraryContest({ sides, hasUsualStart }: Options): fc.Arbitrary<MazeDocument> {
  return fc
    .record({ size: sides, seed: fc.integer(), percent: fc.integer({ min: 0, max: 100 }) })
    .map(({ size, seed, percent }) => {
      const random = createRandom(seed);
      const isWall = (column: number, row: number): boolean => {
        const isPost = column % 2 === 0 && row % 2 === 0;
        const isEdge =
          column === 0 || row === 0 || column === 2 * size.columns || row === 2 * size.rows;
        if (isPost || isEdge) return true;
        if (column % 2 === 1 && row % 2 === 1) return false;
        if (hasUsualStart && column === 2 && row === 2 * size.rows - 1) return true;
        if (hasUsualStart && column === 1 && row === 2 * size.rows - 2) return false;
        return random.below(100) < percent;
      };
      const blocks = Array.from({ length: 2 * size.rows + 1 }, (_, row) =>
        Array.from({ length: 2 * size.columns + 1 }, (__, column) =>
          isWall(column, row) ? BLOCK : OPEN,
        ).join(""),
      );
      return {
        format: "corridor/maze",
        version: 1,
        name: "Any",
        blocks,
        start: contestStart(size),
        goals: contestGoals(size),
      };
    });
}

export const anySides: fc.Arbitrary<ContestSize> = fc.record({
  columns: fc.integer({ min: 1, max: 20 }),
  rows: fc.integer({ min: 1, max: 20 }),
});

/** With any start, any goals, and some posts missing inside. */
export const arbitraryDrawn: fc.Arbitrary<MazeDocument> = fc
  .record({
    maze: arbitraryContest({ sides: anySides, hasUsualStart: false }),
    start: fc.record({ x: fc.nat(), y: fc.nat(), heading: fc.constantFrom(...headingNames) }),
    goals: fc.array(fc.record({ x: fc.nat(), y: fc.nat() }), { minLength: 1, maxLength: 5 }),
    post: fc.record({ column: fc.nat(), row: fc.nat() }),
  })
  .map(({ maze, start, goals, post }) => {
    const size = {
      columns: ((maze.blocks[0]?.length ?? 0) - 1) / 2,
      rows: (maze.blocks.length - 1) / 2,
    };
    const at = ({ x, y }: { x: number; y: number }) =>
      cellOf(size, { x: x % size.columns, y: y % size.rows });
    const cells = new Map(goals.map(at).map((cell) => [cell.row * 256 + cell.column, cell]));
    const blocks = maze.blocks.map((row) => row.split(""));
    if (size.columns > 1 && size.rows > 1) {
      const cellsOfRow = blocks[2 + 2 * (post.row % (size.rows - 1))] ?? [];
      cellsOfRow[2 + 2 * (post.column % (size.columns - 1))] = OPEN;
    }
    return {
      ...maze,
      blocks: blocks.map((row) => row.join("")),
      start: { ...at(start), heading: start.heading },
      goals: [...cells.keys()].toSorted((a, b) => a - b).flatMap((key) => cells.get(key) ?? []),
    };
  });
