/**
 * Codes the blocks of a maze cell by cell. A context model predicts each cell from the cells coded
 * before it. The best model depends on the maze, so the encoder tries several methods.
 */
import { BitModel, type BitCoder } from "./range-coder.ts";
import { codeTree, createTreeModel, type TreeContexts } from "./tree-coder.ts";

/** The cells coded so far, with a margin of blocks, and the index of the next cell. */
interface Neighbourhood {
  cells: Uint8Array;
  at: number;
  stride: number;
}

interface ContextModel {
  contexts: number;
  gain: number;
  /** Returns the context without the bits for edge and parity, from 0 to `contexts` - 1. */
  contextOf: (neighbourhood: Neighbourhood) => number;
  /** whether odd and even cells have separate contexts, for corridors on a lattice */
  byParity: boolean;
}

const nearContext = ({ cells, at, stride }: Neighbourhood): number =>
  (cells[at - 1] ?? 1) * 8 +
  (cells[at - stride] ?? 1) * 4 +
  (cells[at - stride + 1] ?? 1) * 2 +
  (cells[at - stride - 1] ?? 1);

const wideContext = (neighbourhood: Neighbourhood): number => {
  const { cells, at, stride } = neighbourhood;
  return (
    nearContext(neighbourhood) + (cells[at - 2] ?? 1) * 16 + (cells[at - 2 * stride] ?? 1) * 32
  );
};

const widestContext = (neighbourhood: Neighbourhood): number => {
  const { cells, at, stride } = neighbourhood;
  return (
    wideContext(neighbourhood) +
    (cells[at - stride + 2] ?? 1) * 64 +
    (cells[at - stride - 2] ?? 1) * 128 +
    (cells[at - 2 * stride + 1] ?? 1) * 256 +
    (cells[at - 2 * stride - 1] ?? 1) * 512
  );
};

/** Methods by their number in a link. The numbers are part of link version 1: never change them. */
const methods: readonly (ContextModel | TreeContexts)[] = [
  { contexts: 1, gain: 1, contextOf: () => 0, byParity: false },
  { contexts: 16, gain: 4, contextOf: nearContext, byParity: false },
  { contexts: 64, gain: 4, contextOf: wideContext, byParity: false },
  { contexts: 1024, gain: 4, contextOf: widestContext, byParity: false },
  { contexts: 16, gain: 6, contextOf: nearContext, byParity: true },
  { contexts: 64, gain: 6, contextOf: wideContext, byParity: true },
  "neighbours",
  "exits",
];

/**
 * The adaptive models of all methods. Mazes that share them, such as those of a lesson, make each
 * other shorter.
 */
export class BlockModels {
  readonly #models: Map<number, BitModel>;

  constructor(models = new Map<number, BitModel>()) {
    this.#models = models;
  }

  /** @throws RangeError for an unknown method */
  of(method: number): BitModel {
    const existing = this.#models.get(method);
    if (existing !== undefined) return existing;
    const created = createModel(methodOf(method));
    this.#models.set(method, created);
    return created;
  }

  /** Returns models with the same counts. */
  copy(): BlockModels {
    return new BlockModels(new Map([...this.#models].map(([at, each]) => [at, each.copy()])));
  }
}

function methodOf(method: number): ContextModel | TreeContexts {
  const chosen = methods[method];
  if (chosen !== undefined) return chosen;
  throw new RangeError(`method: found ${method}, expected 0 to ${BLOCK_METHOD_COUNT - 1}`);
}

function createModel(method: ContextModel | TreeContexts): BitModel {
  if (typeof method === "string") return createTreeModel();
  // Separate contexts for edge and inside, and for the four parities.
  return new BitModel(method.contexts * 8, method.gain);
}

/** Number of methods. A link stores its method in three bits. */
export const BLOCK_METHOD_COUNT = methods.length;

/** Whether a method supports mazes of this size. */
export function supportsSize(method: number, columns: number, rows: number): boolean {
  const isOdd = columns % 2 === 1 && rows % 2 === 1;
  return typeof methods[method] === "object" || (isOdd && columns >= 3 && rows >= 3);
}

/**
 * Encodes or decodes the blocks.
 * @param method 0 to `BLOCK_METHOD_COUNT` - 1; it must support the size of the maze
 * @param models updated by the cells
 * @param cells 1 for a block, 0 for open, row by row; a decoder ignores them
 * @returns the coded cells, which differ from `cells` if the method cannot represent them
 */
export function codeBlocks(
  coder: BitCoder,
  method: number,
  models: BlockModels,
  columns: number,
  rows: number,
  cells: Uint8Array,
): Uint8Array {
  const chosen = methodOf(method);
  const model = models.of(method);
  if (typeof chosen === "string") return codeTree(coder, columns, rows, cells, chosen, model);

  const stride = columns + 4;
  const padded = new Uint8Array(stride * (rows + 2)).fill(1);
  const coded = new Uint8Array(columns * rows);
  for (let row = 0; row < rows; row += 1) {
    for (let column = 0; column < columns; column += 1) {
      const at = (row + 2) * stride + column + 2;
      const isEdge =
        row === 0 || column === 0 || row === rows - 1 || column === columns - 1 ? 1 : 0;
      const parity = chosen.byParity ? (row & 1) * 2 + (column & 1) : 0;
      const context = chosen.contextOf({ cells: padded, at, stride }) * 8 + parity * 2 + isEdge;
      const bit = model.code(coder, context, cells[row * columns + column] ?? 0);
      padded[at] = bit;
      coded[row * columns + column] = bit;
    }
  }
  return coded;
}
