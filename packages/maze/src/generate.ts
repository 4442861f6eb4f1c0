/**
 * Generates seeded mazes inside a solid border. Every JavaScript engine generates the same document
 * from the same options, so a teacher can share a maze by its kind, size and seed.
 */
import { carveLoops, carveTree, type CellRows } from "./carve-tree.ts";
import { divideRooms } from "./divide-rooms.ts";
import { distancesFromStart } from "./flood-fill.ts";
import { type Cell, type MazeDocument } from "./maze-document.ts";
import { MAX_SIDE, OPEN } from "./maze-limits.ts";
import { createRandom, type Random } from "./random.ts";

/**
 * Kinds of generated mazes:
 * - `tree`: corridors with exactly one path between any two cells
 * - `loops`: a tree with some walls opened, which adds cycles
 * - `rooms`: rooms connected by doors and corridors
 */
export const mazeKinds = ["tree", "loops", "rooms"] as const;
export type MazeKind = (typeof mazeKinds)[number];

export interface TreeOptions {
  /** odd, 5 to 255 */
  columns: number;
  /** odd, 5 to 255 */
  rows: number;
  /** any finite number */
  seed: number;
  name: string;
}

export interface GenerateOptions extends TreeOptions {
  kind: MazeKind;
}

const MIN_SIDE = 5;

const builders: Record<MazeKind, (columns: number, rows: number, random: Random) => CellRows> = {
  tree: carveTree,
  loops: carveLoops,
  rooms: divideRooms,
};

/**
 * Generates a maze in which every open cell is reachable. The start is at (1, 1) with a wall on the
 * right and an open cell ahead, as the right-wall program requires. The goal is the farthest cell.
 * @throws RangeError if a side is even or not from 5 to 255
 */
export function generateMaze({ kind, columns, rows, seed, name }: GenerateOptions): MazeDocument {
  for (const [side, length] of Object.entries({ columns, rows })) {
    const isInRange = length >= MIN_SIDE && length <= MAX_SIDE;
    if (!isInRange || length % 2 !== 1) {
      throw new RangeError(`${side}: found ${length}, expected an odd number from 5 to 255`);
    }
  }
  const grid = builders[kind](columns, rows, createRandom(seed));
  const blocks = grid.map((row) => row.join(""));
  // The robot in the top-left corner has a wall on its right if it faces south (the border), or if
  // it faces east and the cell to the south is blocked. At least one of the two headings is open
  // ahead.
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

/** Generates a maze of kind `tree`. @throws the errors of `generateMaze` */
export function generateTree(options: TreeOptions): MazeDocument {
  return generateMaze({ ...options, kind: "tree" });
}

/** The cell farthest from the start; the first in reading order if several are equally far. */
function farthestCell(maze: MazeDocument, columns: number): Cell {
  const distances = distancesFromStart(maze);
  let farthest = 0;
  for (const [at, distance] of distances.entries()) {
    if (distance > (distances[farthest] ?? 0)) farthest = at;
  }
  return { column: farthest % columns, row: Math.floor(farthest / columns) };
}
