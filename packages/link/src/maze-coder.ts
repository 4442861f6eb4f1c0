/**
 * Codes a maze as bits, with one function for encoding and decoding: size, blocks, start, goals,
 * name.
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
import { BLOCK_METHOD_COUNT, codeBlocks, supportsSize } from "./block-coder.ts";
import { codeName } from "./name-coder.ts";
import { codeUniform, NumberModel } from "./numbers.ts";
import type { BitCoder } from "./range-coder.ts";

/** Choices of an encoder. A decoder reads them from the link. */
export interface MazeChoices {
  /** index of the method for the blocks, 0 to `BLOCK_METHOD_COUNT` - 1 */
  blockMethod: number;
  isPlainName: boolean;
}

/** Returns the cells of a maze row by row, 1 for a block and 0 for an open cell. */
export function cellsOf(maze: MazeDocument): Uint8Array {
  return Uint8Array.from(maze.blocks.join(""), (mark) => (mark === BLOCK ? 1 : 0));
}

/**
 * Encodes or decodes a maze.
 * @param maze the maze to encode; a decoder ignores it, and its caller passes any valid maze
 * @returns the decoded maze, not yet checked by its schema; null if the bits cannot come from an
 *   encoder
 */
export function codeMaze(
  coder: BitCoder,
  maze: MazeDocument,
  choices: MazeChoices,
): MazeDocument | null {
  const size = sizeOf(maze);
  const columns = codeUniform(coder, MAX_SIDE, size.columns - 1) + 1;
  const isSquare = coder.bit(1, 3, size.columns === size.rows ? 1 : 0) === 1;
  const rows = isSquare ? columns : codeUniform(coder, MAX_SIDE, size.rows - 1) + 1;

  const method = codeUniform(coder, BLOCK_METHOD_COUNT, choices.blockMethod);
  if (!supportsSize(method, columns, rows)) return null;
  const cells = codeBlocks(coder, method, columns, rows, cellsOf(maze));
  const open = new OpenCells(cells, columns);
  if (open.count === 0) return null;

  // Most mazes start at their first open cell.
  const startAt = open.indexOf(maze.start);
  const isFirst = coder.bit(1, 2, startAt === 0 ? 1 : 0) === 1;
  const start = open.cellAt(isFirst ? 0 : codeUniform(coder, open.count, startAt));
  const heading = headingNames[codeUniform(coder, 4, headingNames.indexOf(maze.start.heading))];
  if (heading === undefined) return null;

  const isOneGoal = coder.bit(1, 7, maze.goals.length === 1 ? 1 : 0) === 1;
  const goalCount = isOneGoal ? 1 : new NumberModel().code(coder, maze.goals.length);
  if (goalCount > MAX_GOALS) return null;
  const goals = Array.from({ length: goalCount }, (_, at) => {
    const goal = maze.goals[at];
    return open.cellAt(codeUniform(coder, open.count, goal === undefined ? 0 : open.indexOf(goal)));
  });

  const name = codeName(coder, maze.name, MAX_NAME_LENGTH, choices.isPlainName);
  const blocks = Array.from({ length: rows }, (_, row) =>
    Array.from(cells.subarray(row * columns, (row + 1) * columns), (cell) =>
      cell === 1 ? BLOCK : OPEN,
    ).join(""),
  );
  return { format: "corridor/maze", version: 1, name, blocks, start: { ...start, heading }, goals };
}

/**
 * The open cells of a maze, in reading order. The start and the goals are coded by their index
 * here.
 */
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

  indexOf({ column, row }: Cell): number {
    return this.#cells.indexOf(row * this.#columns + column);
  }

  cellAt(index: number): Cell {
    const at = this.#cells[index] ?? 0;
    const column = at % this.#columns;
    return { column, row: (at - column) / this.#columns };
  }
}
