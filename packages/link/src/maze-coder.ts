/**
 * A maze as bits, written and read by one function: size, blocks, start, goals, name.
 */
import {
  BLOCK,
  headingNames,
  MAX_GOALS,
  MAX_NAME_LENGTH,
  MAX_SIDE,
  OPEN,
  sizeOf,
  type Cell,
  type MazeDocument,
} from "@corridor/maze";
import { BLOCK_WAYS, codeBlocks, suitsSize } from "./block-coder.ts";
import { codeName } from "./name-coder.ts";
import { codeUniform, NumberModel } from "./numbers.ts";
import type { BitCoder } from "./range-coder.ts";

/** What an encoder may choose; a decoder finds it in the link. */
export interface MazeWays {
  /** 0 to `BLOCK_WAYS` - 1 */
  blocks: number;
  isPlainName: boolean;
}

/** The cells of a maze, 1 for a block and 0 for open, row by row. */
export function cellsOf(maze: MazeDocument): Uint8Array {
  return Uint8Array.from(maze.blocks.join(""), (mark) => (mark === BLOCK ? 1 : 0));
}

/**
 * Writes or reads a maze.
 * @param maze what to write; a decoder is given any legal maze and ignores it
 * @returns the maze as a decoder will read it, still to be checked by its schema; null where a link
 * asks for what no encoder writes
 */
export function codeMaze(coder: BitCoder, maze: MazeDocument, ways: MazeWays): MazeDocument | null {
  const size = sizeOf(maze);
  const columns = codeUniform(coder, MAX_SIDE, size.columns - 1) + 1;
  const isSquare = coder.bit(1, 3, size.columns === size.rows ? 1 : 0) === 1;
  const rows = isSquare ? columns : codeUniform(coder, MAX_SIDE, size.rows - 1) + 1;

  const way = codeUniform(coder, BLOCK_WAYS, ways.blocks);
  if (!suitsSize(way, columns, rows)) return null;
  const cells = codeBlocks(coder, way, columns, rows, cellsOf(maze));
  const open = new OpenCells(cells, columns);
  if (open.count === 0) return null;

  // Most mazes start at their first open cell.
  const startAt = open.placeOf(maze.start);
  const isFirst = coder.bit(1, 2, startAt === 0 ? 1 : 0) === 1;
  const start = open.cellAt(isFirst ? 0 : codeUniform(coder, open.count, startAt));
  const heading = headingNames[codeUniform(coder, 4, headingNames.indexOf(maze.start.heading))];
  if (heading === undefined) return null;

  const isOneGoal = coder.bit(1, 7, maze.goals.length === 1 ? 1 : 0) === 1;
  const goalCount = isOneGoal ? 1 : new NumberModel().code(coder, maze.goals.length);
  if (goalCount > MAX_GOALS) return null;
  const goals = Array.from({ length: goalCount }, (_, at) => {
    const goal = maze.goals[at];
    return open.cellAt(codeUniform(coder, open.count, goal === undefined ? 0 : open.placeOf(goal)));
  });

  const name = codeName(coder, maze.name, MAX_NAME_LENGTH, ways.isPlainName);
  const blocks = Array.from({ length: rows }, (_, row) =>
    Array.from(cells.subarray(row * columns, (row + 1) * columns), (cell) =>
      cell === 1 ? BLOCK : OPEN,
    ).join(""),
  );
  return { format: "corridor/maze", version: 1, name, blocks, start: { ...start, heading }, goals };
}

/** Open cells by their place among the open ones: start and goals stand on no others. */
class OpenCells {
  readonly #columns: number;
  readonly #cells: readonly number[];

  constructor(cells: Uint8Array, columns: number) {
    this.#columns = columns;
    const open: number[] = [];
    for (const [at, cell] of cells.entries()) if (cell === 0) open.push(at);
    this.#cells = open;
  }

  get count(): number {
    return this.#cells.length;
  }

  placeOf({ column, row }: Cell): number {
    return this.#cells.indexOf(row * this.#columns + column);
  }

  cellAt(place: number): Cell {
    const at = this.#cells[place] ?? 0;
    const column = at % this.#columns;
    return { column, row: (at - column) / this.#columns };
  }
}
