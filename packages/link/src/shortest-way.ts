/** What an encoder may choose: every way is tried on its own, and the shortest is taken. */
import { sizeOf, type MazeDocument } from "@corridor/maze";
import { BLOCK_WAYS, codeBlocks, suitsSize } from "./block-coder.ts";
import { cellsOf } from "./maze-coder.ts";
import { canBePlain, codeName } from "./name-coder.ts";
import { Encoder } from "./range-coder.ts";

/** The number of the way in which the blocks of a maze take the fewest characters. */
export function shortestBlockWay(maze: MazeDocument): number {
  const { columns, rows } = sizeOf(maze);
  const cells = cellsOf(maze);
  let shortest = 0;
  let fewest = Number.POSITIVE_INFINITY;
  for (let way = 0; way < BLOCK_WAYS; way += 1) {
    if (!suitsSize(way, columns, rows)) continue;
    const encoder = new Encoder();
    const told = codeBlocks(encoder, way, columns, rows, cells);
    const length = encoder.finish().length;
    if (length < fewest && told.every((cell, at) => cell === cells[at])) {
      shortest = way;
      fewest = length;
    }
  }
  return shortest;
}

/** Whether a name takes fewer characters as plain seven-bit ones. */
export function isShorterPlain(name: string): boolean {
  return canBePlain(name) && nameLength(name, true) < nameLength(name, false);
}

function nameLength(name: string, isPlain: boolean): number {
  const encoder = new Encoder();
  codeName(encoder, name, name.length, isPlain);
  return encoder.finish().length;
}
