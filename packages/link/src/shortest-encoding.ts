/** Finds the shortest encoding by trying all choices of an encoder separately. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { BLOCK_METHOD_COUNT, codeBlocks, supportsSize, type BlockModels } from "./block-coder.ts";
import type { Choices } from "./choices.ts";
import { cellsOf } from "./maze-coder.ts";
import { canBePlain, codeName } from "./name-coder.ts";
import { Encoder } from "./range-coder.ts";

export const shortest: Choices = {
  blockMethodOf: shortestBlockMethod,
  isPlainName: isShorterPlain,
};

/**
 * Index of the method that encodes the blocks of a maze with the fewest characters.
 * @param models not changed
 */
function shortestBlockMethod(maze: MazeDocument, models: BlockModels): number {
  const { columns, rows } = sizeOf(maze);
  const cells = cellsOf(maze);
  let best = 0;
  let fewest = Number.POSITIVE_INFINITY;
  for (let method = 0; method < BLOCK_METHOD_COUNT; method += 1) {
    if (!supportsSize(method, columns, rows)) continue;
    const encoder = new Encoder();
    const decoded = codeBlocks(encoder, method, models.copy(), columns, rows, cells);
    const length = encoder.finish().length;
    if (length < fewest && decoded.every((cell, at) => cell === cells[at])) {
      best = method;
      fewest = length;
    }
  }
  return best;
}

/** Whether the plain seven-bit encoding of a name needs fewer characters. */
function isShorterPlain(name: string): boolean {
  return canBePlain(name) && nameLength(name, true) < nameLength(name, false);
}

function nameLength(name: string, isPlain: boolean): number {
  const encoder = new Encoder();
  codeName(encoder, name, name.length, isPlain);
  return encoder.finish().length;
}
