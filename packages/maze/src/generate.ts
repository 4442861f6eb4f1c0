/**
 * Seeded mazes inside a solid border. The same options give the same document in every engine, so that
 * a teacher can dictate a maze: its kind, its size and its seed.
 */
import { carveLoops, carveTree, type CellRows } from "./carve-tree.ts";
import { divideRooms } from "./divide-rooms.ts";
import { distancesFromStart } from "./flood-fill.ts";
import { type Cell, type MazeDocument } from "./maze-document.ts";
import { MAX_SIDE, OPEN } from "./maze-limits.ts";
import { createRandom, type Random } from "./random.ts";

/**
 * What a generated maze is made of:
 * `tree`: corridors with exactly one way between any two cells;
 * `loops`: such corridors with some walls opened, so that there are ways round;
 * `rooms`: rooms joined by doors and corridors.
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
 * A maze of a kind. Every open cell can be reached. The start is at (1, 1) with a wall on the right and
 * open ahead, as the right-wall program wants it; the goal is the farthest cell from there.
 * @throws RangeError when a side is even or not from 5 to 255
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
  // A robot in the top-left corner has a wall on its right when it faces east and the way south is
  // shut, and when it faces south (its right is the border). One of the two always leads on.
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

/** A maze of kind `tree`. @throws as `generateMaze` */
export function generateTree(options: TreeOptions): MazeDocument {
  return generateMaze({ ...options, kind: "tree" });
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
