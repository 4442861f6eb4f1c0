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
import { BLOCK_METHOD_COUNT, BlockModels, codeBlocks, supportsSize } from "./block-coder.ts";
import type { Choices } from "./choices.ts";
import { codeName } from "./name-coder.ts";
import { codeUniform, NumberModel } from "./numbers.ts";
import { BitModel, type BitCoder } from "./range-coder.ts";

/** Returns the cells of a maze row by row, 1 for a block and 0 for an open cell. */
export function cellsOf(maze: MazeDocument): Uint8Array {
  const marks = maze.blocks.join("");
  const cells = new Uint8Array(marks.length);
  for (let at = 0; at < cells.length; at++) if (marks[at] === BLOCK) cells[at] = 1;
  return cells;
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
  choices: Choices,
): MazeDocument | null {
  const layout = new LayoutCoder(choices).code(coder, maze);
  if (layout === null) return null;
  const isPlain = choices.isPlainName(maze.name);
  return { ...layout, name: codeName(coder, maze.name, MAX_NAME_LENGTH, isPlain) };
}

/** Contexts of the adaptive bits: does the maze have the size, or the method, of the one before. */
const SAME_SIZE = 0;
const SAME_METHOD = 1;

/** Size of a maze, and the method that codes its blocks. */
interface Shape {
  columns: number;
  rows: number;
  method: number;
}

/** Codes mazes without their names. Each maze is predicted from the previous ones. */
export class LayoutCoder {
  readonly #choices: Choices;
  readonly #blocks = new BlockModels();
  readonly #bits = new BitModel(2, 4);
  #before: Shape | null = null;

  constructor(choices: Choices) {
    this.#choices = choices;
  }

  /** @returns as `codeMaze`, with an empty name */
  code(coder: BitCoder, maze: MazeDocument): MazeDocument | null {
    const shape = this.#codeShape(coder, maze);
    if (shape === null) return null;
    const { columns, rows, method } = shape;
    const cells = codeBlocks(coder, method, this.#blocks, columns, rows, cellsOf(maze));
    return codeMarks(coder, maze, shape, cells);
  }

  /** @returns null if the method does not support the size */
  #codeShape(coder: BitCoder, maze: MazeDocument): Shape | null {
    const size = sizeOf(maze);
    const before = this.#before;
    const isSameSize = before?.columns === size.columns && before.rows === size.rows;
    const { columns, rows } =
      before !== null && this.#isSame(coder, SAME_SIZE, isSameSize)
        ? before
        : codeSize(coder, size);
    const chosen = this.#choices.blockMethodOf(maze, this.#blocks);
    const method =
      before !== null && this.#isSame(coder, SAME_METHOD, before.method === chosen)
        ? before.method
        : codeUniform(coder, BLOCK_METHOD_COUNT, chosen);
    this.#before = { columns, rows, method };
    return supportsSize(method, columns, rows) ? this.#before : null;
  }

  #isSame(coder: BitCoder, context: number, isSame: boolean): boolean {
    return this.#bits.code(coder, context, isSame ? 1 : 0) === 1;
  }
}

function codeSize(coder: BitCoder, size: Omit<Shape, "method">): Omit<Shape, "method"> {
  const columns = codeUniform(coder, MAX_SIDE, size.columns - 1) + 1;
  const isSquare = coder.bit(1, 3, size.columns === size.rows ? 1 : 0) === 1;
  return { columns, rows: isSquare ? columns : codeUniform(coder, MAX_SIDE, size.rows - 1) + 1 };
}

/** Codes start and goals. @returns the maze without its name, or null */
function codeMarks(
  coder: BitCoder,
  maze: MazeDocument,
  { columns, rows }: Shape,
  cells: Uint8Array,
): MazeDocument | null {
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

  return {
    format: "corridor/maze",
    version: 1,
    name: "",
    blocks: blocksOf(cells, columns, rows),
    start: { ...start, heading },
    goals,
  };
}

/** The inverse of `cellsOf`. Loops, because a lesson has up to 120 mazes of 65,536 cells. */
function blocksOf(cells: Uint8Array, columns: number, rows: number): string[] {
  const blocks: string[] = [];
  for (let row = 0; row < rows; row++) {
    let marks = "";
    for (let column = 0; column < columns; column++) {
      marks += cells[row * columns + column] === 1 ? BLOCK : OPEN;
    }
    blocks.push(marks);
  }
  return blocks;
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
