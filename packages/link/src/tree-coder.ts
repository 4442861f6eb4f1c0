/**
 * Codes the blocks of a perfect maze: corridors on the odd cells, posts on the even ones, a solid
 * border, and exactly one path between any two open cells. Only walls between two corridor cells
 * are coded. Two kinds of walls need no bits: a wall whose opening would close a cycle must be a
 * block, and the last exit of a connected set of cells must be open.
 */
import { BitModel, type BitCoder } from "./range-coder.ts";

/** Source of the contexts. Neighbours are better for long winding corridors. */
export type TreeContexts = "neighbours" | "exits";

/** Creates the adaptive model of walls. */
export function createTreeModel(): BitModel {
  return new BitModel(16, 1);
}

/**
 * Encodes or decodes the blocks.
 * @param columns odd, at least 3, as `rows`
 * @param cells 1 for a block, 0 for open, row by row; a decoder ignores them
 * @param model updated by the walls
 * @returns the decoded cells, which differ from `cells` if these are not a perfect maze
 */
export function codeTree(
  coder: BitCoder,
  columns: number,
  rows: number,
  cells: Uint8Array,
  contexts: TreeContexts,
  model: BitModel,
): Uint8Array {
  const coded = new Uint8Array(columns * rows).fill(1);
  const sets = new CellSets(columns, rows);

  const codeWall = (at: number, from: number, to: number, context: number): void => {
    const [a, b] = sets.visitWall(from, to);
    if (a === b) return;
    const exits = Math.min(sets.exitsOf(a), sets.exitsOf(b));
    const modelContext = contexts === "exits" ? Math.min(exits, 3) + (context & 8) : context;
    const isBlock = exits === 0 ? 0 : model.code(coder, modelContext, cells[at] ?? 0);
    coded[at] = isBlock;
    if (isBlock === 0) sets.merge(a, b);
  };

  for (let row = 1; row < rows; row += 2) {
    for (let column = 1; column < columns; column += 2) {
      const at = row * columns + column;
      coded[at] = 0;
      if (column + 2 < columns) codeWall(at + 1, at, at + 2, contextBeside(coded, at, columns));
    }
    if (row + 2 >= rows) break;
    for (let column = 1; column < columns; column += 2) {
      const at = row * columns + column;
      codeWall(at + columns, at, at + 2 * columns, contextBelow(coded, at, columns));
    }
  }
  return coded;
}

/** Context of the wall right of a corridor cell: openings in the west, north and north-east. */
function contextBeside(coded: Uint8Array, at: number, columns: number): number {
  const beyond = coded[at - columns + 2] ?? 1;
  return (coded[at - 1] ?? 1) * 4 + (coded[at - columns] ?? 1) * 2 + beyond;
}

/** Context of the wall below a corridor cell: openings in the west, east and north. */
function contextBelow(coded: Uint8Array, at: number, columns: number): number {
  return 8 + (coded[at - 1] ?? 1) * 4 + (coded[at + 1] ?? 1) * 2 + (coded[at - columns] ?? 1);
}

/** Union-find of connected corridor cells, with the number of uncoded walls around each set. */
class CellSets {
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

  /** Marks the wall between two corridor cells as coded, and returns their sets. */
  visitWall(from: number, to: number): [number, number] {
    const sets: [number, number] = [this.#find(from), this.#find(to)];
    for (const set of sets) this.#exits[set] = this.exitsOf(set) - 1;
    return sets;
  }

  exitsOf(set: number): number {
    return this.#exits[set] ?? 0;
  }

  merge(a: number, b: number): void {
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
