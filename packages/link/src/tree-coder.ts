/**
 * Blocks of a perfect maze: corridors on the odd cells, posts on the even ones, a solid border, and
 * exactly one way between any two open cells. Only the cells between two corridors cells are told, and
 * not even all of them: an opening that would close a loop must be a block, and the last way out of
 * what has been joined so far must be open.
 */
import { BitModel, type BitCoder } from "./range-coder.ts";

/** Which hints the bits are told with: the neighbours suit long winding corridors. */
export type TreeHints = "neighbours" | "exits";

/**
 * Writes or reads the blocks.
 * @param columns odd, at least 3, as `rows`
 * @param cells 1 for a block, 0 for open, row by row; a decoder ignores them
 * @returns the cells as a decoder will read them: others than those given where they are no perfect maze
 */
export function codeTree(
  coder: BitCoder,
  columns: number,
  rows: number,
  cells: Uint8Array,
  hints: TreeHints,
): Uint8Array {
  const coded = new Uint8Array(columns * rows).fill(1);
  const model = new BitModel(16, 1);
  const joined = new JoinedCells(columns, rows);

  const codeBetween = (at: number, from: number, to: number, context: number): void => {
    const [a, b] = joined.passBy(from, to);
    if (a === b) return;
    const exits = Math.min(joined.exitsOf(a), joined.exitsOf(b));
    const hint = hints === "exits" ? Math.min(exits, 3) + (context & 8) : context;
    const isBlock = exits === 0 ? 0 : model.code(coder, hint, cells[at] ?? 0);
    coded[at] = isBlock;
    if (isBlock === 0) joined.join(a, b);
  };

  for (let row = 1; row < rows; row += 2) {
    for (let column = 1; column < columns; column += 2) {
      const at = row * columns + column;
      coded[at] = 0;
      if (column + 2 < columns) codeBetween(at + 1, at, at + 2, contextBeside(coded, at, columns));
    }
    if (row + 2 >= rows) break;
    for (let column = 1; column < columns; column += 2) {
      const at = row * columns + column;
      codeBetween(at + columns, at, at + 2 * columns, contextBelow(coded, at, columns));
    }
  }
  return coded;
}

/** What is known around the cell on the right of a corridor cell: ways west, north, north-east. */
function contextBeside(coded: Uint8Array, at: number, columns: number): number {
  const beyond = coded[at - columns + 2] ?? 1;
  return (coded[at - 1] ?? 1) * 4 + (coded[at - columns] ?? 1) * 2 + beyond;
}

/** What is known around the cell below a corridor cell: ways west, east, north. */
function contextBelow(coded: Uint8Array, at: number, columns: number): number {
  return 8 + (coded[at - 1] ?? 1) * 4 + (coded[at + 1] ?? 1) * 2 + (coded[at - columns] ?? 1);
}

/** Which corridor cells are joined by openings, and how many cells could still lead out of each set. */
class JoinedCells {
  readonly #parents: Int32Array;
  readonly #exits: Int32Array;

  constructor(columns: number, rows: number) {
    this.#parents = Int32Array.from({ length: columns * rows }, (_, at) => at);
    this.#exits = new Int32Array(columns * rows);
    for (let row = 1; row < rows; row += 2) {
      for (let column = 1; column < columns; column += 2) {
        const sides = [column > 1, column + 2 < columns, row > 1, row + 2 < rows];
        this.#exits[row * columns + column] = sides.filter(Boolean).length;
      }
    }
  }

  /** Counts the cell between two corridor cells as told, and names the sets of both. */
  passBy(from: number, to: number): [number, number] {
    const sets: [number, number] = [this.#find(from), this.#find(to)];
    for (const set of sets) this.#exits[set] = this.exitsOf(set) - 1;
    return sets;
  }

  exitsOf(set: number): number {
    return this.#exits[set] ?? 0;
  }

  join(a: number, b: number): void {
    this.#exits[b] = this.exitsOf(a) + this.exitsOf(b);
    this.#parents[a] = b;
  }

  #find(at: number): number {
    let set = at;
    for (let up = this.#parents[set] ?? set; up !== set; up = this.#parents[set] ?? set) {
      this.#parents[set] = this.#parents[up] ?? up;
      set = this.#parents[set] ?? set;
    }
    return set;
  }
}
