/**
 * Seeded mazes. The same options give the same document in every engine.
 *
 * A tree maze has corridors one cell wide on the odd cells inside a solid border, and exactly one
 * way between any two open cells.
 */
import { distancesFromStart } from "./flood-fill.ts";
import { type Cell, type MazeDocument } from "./maze-document.ts";
import { BLOCK, MAX_SIDE, OPEN } from "./maze-limits.ts";
import { createRandom } from "./random.ts";

export interface TreeOptions {
  /** odd, 5 to 255 */
  columns: number;
  /** odd, 5 to 255 */
  rows: number;
  /** any finite number */
  seed: number;
  name: string;
}

const MIN_TREE_SIDE = 5;

const steps = [
  { column: 0, row: -1 },
  { column: 1, row: 0 },
  { column: 0, row: 1 },
  { column: -1, row: 0 },
] as const;

/**
 * A tree maze by depth-first search. The start is at (1, 1) with a wall on the right and open ahead,
 * as the right-wall program wants it; the goal is the farthest cell from there.
 * @throws RangeError when a side is even or not from 5 to 255
 */
export function generateTree({ columns, rows, seed, name }: TreeOptions): MazeDocument {
  for (const [side, length] of Object.entries({ columns, rows })) {
    const isInRange = length >= MIN_TREE_SIDE && length <= MAX_SIDE;
    if (!isInRange || length % 2 !== 1) {
      throw new RangeError(`${side}: found ${length}, expected an odd number from 5 to 255`);
    }
  }
  const grid = carve(columns, rows, seed);
  const blocks = grid.map((row) => row.join(""));
  // A robot in the top-left corner has a wall on its right when it faces east and the way south is
  // shut, and when it faces south (its right is the border). In a tree one of the two always holds.
  const isSouthOpen = grid[2]?.[1] === OPEN;
  const maze: MazeDocument = {
    format: "corridor/maze",
    version: 1,
    name,
    blocks,
    start: { column: 1, row: 1, heading: isSouthOpen ? "south" : "east" },
    goals: [],
  };
  return { ...maze, goals: [farthestCell(maze, columns)] };
}

/** Walks from (1, 1) to unvisited cells two steps away, at random, and goes back where it is stuck. */
function carve(columns: number, rows: number, seed: number): string[][] {
  const random = createRandom(seed);
  const grid = Array.from({ length: rows }, () =>
    Array.from({ length: columns }, (): string => BLOCK),
  );
  const open = ({ column, row }: Cell): void => {
    const cells = grid[row];
    if (cells !== undefined) cells[column] = OPEN;
  };
  const path: Cell[] = [{ column: 1, row: 1 }];
  open({ column: 1, row: 1 });
  for (let here = path.at(-1); here !== undefined; here = path.at(-1)) {
    const { column, row } = here;
    const ways = steps.filter(
      (step) => grid[row + 2 * step.row]?.[column + 2 * step.column] === BLOCK,
    );
    const way = ways.length === 0 ? undefined : ways[random.below(ways.length)];
    if (way === undefined) {
      path.pop();
      continue;
    }
    const next = { column: column + 2 * way.column, row: row + 2 * way.row };
    open({ column: column + way.column, row: row + way.row });
    open(next);
    path.push(next);
  }
  return grid;
}

/** The first, reading from the top-left, of the cells that are farthest from the start. */
function farthestCell(maze: MazeDocument, columns: number): Cell {
  const distances = distancesFromStart(maze);
  let farthest = 0;
  for (const [at, distance] of distances.entries()) {
    if (distance > (distances[farthest] ?? 0)) farthest = at;
  }
  return { column: farthest % columns, row: Math.floor(farthest / columns) };
}
