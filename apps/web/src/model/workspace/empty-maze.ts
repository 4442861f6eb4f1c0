import type { MazeDocument } from "@corridor/maze";

const COLUMNS = 11;
const ROWS = 7;

/** A maze without blocks and goals. The start is at the bottom left. */
export function emptyMaze(name: string): MazeDocument {
  return {
    format: "corridor/maze",
    version: 1,
    name,
    blocks: Array.from({ length: ROWS }, () => ".".repeat(COLUMNS)),
    start: { column: 0, row: ROWS - 1, heading: "east" },
    goals: [],
  };
}
