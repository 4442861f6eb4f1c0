/** Finds the shortest encoding by trying all choices of an encoder separately. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { BLOCK_METHOD_COUNT, codeBlocks, supportsSize } from "./block-coder.ts";
import { cellsOf } from "./maze-coder.ts";
import { canBePlain, codeName } from "./name-coder.ts";
import { Encoder } from "./range-coder.ts";

/** Index of the method that encodes the blocks of a maze with the fewest characters. */
export function shortestBlockMethod(maze: MazeDocument): number {
  const { columns, rows } = sizeOf(maze);
  const cells = cellsOf(maze);
  let shortest = 0;
  let fewest = Number.POSITIVE_INFINITY;
  for (let method = 0; method < BLOCK_METHOD_COUNT; method += 1) {
    if (!supportsSize(method, columns, rows)) continue;
    const encoder = new Encoder();
    const decoded = codeBlocks(encoder, method, columns, rows, cells);
    const length = encoder.finish().length;
    if (length < fewest && decoded.every((cell, at) => cell === cells[at])) {
      shortest = method;
      fewest = length;
    }
  }
  return shortest;
}

/** Whether the plain seven-bit encoding of a name needs fewer characters. */
export function isShorterPlain(name: string): boolean {
  return canBePlain(name) && nameLength(name, true) < nameLength(name, false);
}

function nameLength(name: string, isPlain: boolean): number {
  const encoder = new Encoder();
  codeName(encoder, name, name.length, isPlain);
  return encoder.finish().length;
}
