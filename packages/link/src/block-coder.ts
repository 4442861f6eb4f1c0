/**
 * Blocks of a maze, cell by cell, each foretold from those around it that are known already. How best
 * to foretell depends on the maze, so there are several ways; the encoder tries them all.
 */
import { BitModel, type BitCoder } from "./range-coder.ts";
import { codeTree } from "./tree-coder.ts";

/** The cells known so far with a margin of blocks, and where the next one stands. */
interface Surroundings {
  known: Uint8Array;
  at: number;
  stride: number;
}

interface Way {
  contexts: number;
  gain: number;
  /** the context without what `isEdge` and the parity add, from 0 to `contexts` - 1 */
  look: (around: Surroundings) => number;
  /** whether odd and even cells learn apart, for corridors on a lattice */
  byParity: boolean;
}

const near = ({ known, at, stride }: Surroundings): number =>
  (known[at - 1] ?? 1) * 8 +
  (known[at - stride] ?? 1) * 4 +
  (known[at - stride + 1] ?? 1) * 2 +
  (known[at - stride - 1] ?? 1);

const wide = (around: Surroundings): number => {
  const { known, at, stride } = around;
  return near(around) + (known[at - 2] ?? 1) * 16 + (known[at - 2 * stride] ?? 1) * 32;
};

const widest = (around: Surroundings): number => {
  const { known, at, stride } = around;
  return (
    wide(around) +
    (known[at - stride + 2] ?? 1) * 64 +
    (known[at - stride - 2] ?? 1) * 128 +
    (known[at - 2 * stride + 1] ?? 1) * 256 +
    (known[at - 2 * stride - 1] ?? 1) * 512
  );
};

/** By their number in a link; the numbers belong to link version 1 for ever. */
const ways: readonly (Way | "neighbours" | "exits")[] = [
  { contexts: 1, gain: 1, look: () => 0, byParity: false },
  { contexts: 16, gain: 4, look: near, byParity: false },
  { contexts: 64, gain: 4, look: wide, byParity: false },
  { contexts: 1024, gain: 4, look: widest, byParity: false },
  { contexts: 16, gain: 6, look: near, byParity: true },
  { contexts: 64, gain: 6, look: wide, byParity: true },
  "neighbours",
  "exits",
];

/** How many ways there are; a link says its way in three bits. */
export const BLOCK_WAYS = ways.length;

/** Whether a way can be tried on a maze of this size. */
export function suitsSize(way: number, columns: number, rows: number): boolean {
  const isOdd = columns % 2 === 1 && rows % 2 === 1;
  return typeof ways[way] === "object" || (isOdd && columns >= 3 && rows >= 3);
}

/**
 * Writes or reads the blocks.
 * @param way 0 to `BLOCK_WAYS` - 1, and `suitsSize` holds
 * @param cells 1 for a block, 0 for open, row by row; a decoder ignores them
 * @returns the cells as a decoder will read them: others than those given where the way cannot tell them
 */
export function codeBlocks(
  coder: BitCoder,
  way: number,
  columns: number,
  rows: number,
  cells: Uint8Array,
): Uint8Array {
  const chosen = ways[way];
  if (chosen === undefined)
    throw new RangeError(`way: found ${way}, expected 0 to ${BLOCK_WAYS - 1}`);
  if (typeof chosen === "string") return codeTree(coder, columns, rows, cells, chosen);

  const stride = columns + 4;
  const known = new Uint8Array(stride * (rows + 2)).fill(1);
  const coded = new Uint8Array(columns * rows);
  // Edge or inside, and the four parities, learn apart.
  const model = new BitModel(chosen.contexts * 8, chosen.gain);
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      const at = (row + 2) * stride + column + 2;
      const isEdge =
        row === 0 || column === 0 || row === rows - 1 || column === columns - 1 ? 1 : 0;
      const parity = chosen.byParity ? (row & 1) * 2 + (column & 1) : 0;
      const context = chosen.look({ known, at, stride }) * 8 + parity * 2 + isEdge;
      const bit = model.code(coder, context, cells[row * columns + column] ?? 0);
      known[at] = bit;
      coded[row * columns + column] = bit;
    }
  }
  return coded;
}
