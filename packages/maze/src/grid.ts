/**
 * The maze as a lookup table for physics and sensors: one byte per cell, with a solid border around
 * it, so that lookups next to the edge need no bounds check.
 */
import { sizeOf } from "./maze-cells.ts";
import { type MazeDocument } from "./maze-document.ts";
import { BLOCK } from "./maze-limits.ts";

/** Side of a cell in units (cm). */
export const CELL = 100;

export interface Grid {
  columns: number;
  rows: number;
  /** array elements per row; cell (c, r) is `solid[(r + 1) * stride + c + 1]` */
  stride: number;
  /** 1 for a block or the border, 0 for an open cell */
  solid: Uint8Array;
}

/** Builds the lookup table in time linear in the number of cells. */
export function gridOf(maze: MazeDocument): Grid {
  const { columns, rows } = sizeOf(maze);
  const stride = columns + 2;
  const solid = new Uint8Array(stride * (rows + 2)).fill(1);
  for (const [row, text] of maze.blocks.entries()) {
    const base = (row + 1) * stride + 1;
    for (let column = 0; column < columns; column++) {
      if (text[column] !== BLOCK) solid[base + column] = 0;
    }
  }
  return { columns, rows, stride, solid };
}
