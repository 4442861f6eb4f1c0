/** The walls of a contest maze as number lists and binary files store them: four bits per cell. */
import { BLOCK, OPEN, type HeadingName } from "../maze-limits.ts";
import { cellOf, type ContestCell, type ContestSize } from "./contest-cells.ts";

export interface WallTable extends ContestSize {
  /** bits of `sides`, at index `x * rows + y` */
  walls: Uint8Array;
}

export interface Side {
  name: HeadingName;
  bit: number;
  /** bit of the same wall, seen from the neighbour */
  opposite: number;
  dx: number;
  dy: number;
}

/** The sides of a cell, clockwise. */
export const sides: readonly Side[] = [
  { name: "north", bit: 1, opposite: 4, dx: 0, dy: 1 },
  { name: "east", bit: 2, opposite: 8, dx: 1, dy: 0 },
  { name: "south", bit: 4, opposite: 1, dx: 0, dy: -1 },
  { name: "west", bit: 8, opposite: 2, dx: -1, dy: 0 },
];

/** A wall that is missing in the outer wall, or that only one of its two cells has. */
export interface WallFault {
  cell: ContestCell;
  side: Side;
  /** null: the side is part of the outer wall */
  neighbour: ContestCell | null;
}

export function wallsAt({ rows, walls }: WallTable, { x, y }: ContestCell): number {
  return walls[x * rows + y] ?? 0;
}

/** The neighbour of a cell, whether or not a wall is between; null outside of the maze. */
export function neighbourOf(
  { columns, rows }: ContestSize,
  { x, y }: ContestCell,
  { dx, dy }: Side,
): ContestCell | null {
  const to = { x: x + dx, y: y + dy };
  return to.x >= 0 && to.x < columns && to.y >= 0 && to.y < rows ? to : null;
}

/** All cells, from the bottom of the first column to the top of the last. */
export function* cellsOf({ columns, rows }: ContestSize): Generator<ContestCell> {
  for (let x = 0; x < columns; x++) for (let y = 0; y < rows; y++) yield { x, y };
}

/** Finds gaps in the outer wall, and sides without a wall that their neighbour has. */
export function* wallFaults(table: WallTable): Generator<WallFault> {
  for (const cell of cellsOf(table)) {
    for (const side of sides) {
      if ((wallsAt(table, cell) & side.bit) !== 0) continue;
      const neighbour = neighbourOf(table, cell, side);
      if (neighbour === null || (wallsAt(table, neighbour) & side.opposite) !== 0) {
        yield { cell, side, neighbour };
      }
    }
  }
}

/** The blocks of the document. All posts are blocks. */
export function blocksOf(table: WallTable): string[] {
  const { columns, rows } = table;
  const blocks = Array.from({ length: 2 * rows + 1 }, () =>
    Array.from({ length: 2 * columns + 1 }, () => BLOCK),
  );
  for (const cell of cellsOf(table)) {
    const { column, row } = cellOf(table, cell);
    const open = (right: number, down: number): void => {
      const cells = blocks[row + down];
      if (cells !== undefined) cells[column + right] = OPEN;
    };
    open(0, 0);
    for (const { bit, dx, dy } of sides) {
      if ((wallsAt(table, cell) & bit) === 0) open(dx, -dy);
    }
  }
  return blocks.map((cells) => cells.join(""));
}
