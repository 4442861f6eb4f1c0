/** The measuring tape: from one point of the maze to another, in whole centimetres. Pure. */
import type { Cell } from "@corridor/maze";
import type { TFunction } from "i18next";
import { CELL, type Layout } from "../../canvas/viewport.ts";
import { localNumber } from "../../text/numbers.ts";

/** A place in the maze, in whole centimetres. */
export interface TapePoint {
  x: number;
  y: number;
}

export interface Tape {
  from: TapePoint;
  to: TapePoint;
  /** whether the second point is still looked for */
  isOpen: boolean;
}

/** The middle of a square. */
export function middleOf({ column, row }: Cell): TapePoint {
  return { x: (column + 0.5) * CELL, y: (row + 0.5) * CELL };
}

/** The square that a point lies in. */
export function cellAtPoint({ x, y }: TapePoint): Cell {
  return { column: Math.floor(x / CELL), row: Math.floor(y / CELL) };
}

/**
 * The nearest point of the maze.
 * @param x pixels from the maze's left edge
 * @param y pixels from the maze's top edge
 */
export function tapePointAt(layout: Layout, x: number, y: number): TapePoint {
  const along = (pixels: number, cells: number): number =>
    Math.min(cells * CELL, Math.max(0, Math.round((pixels * CELL) / layout.cellPx)));
  return { x: along(x, layout.columns), y: along(y, layout.rows) };
}

/** Length and both sides of a tape in centimetres, the length in whole ones; `down` is negative upward. */
export function tapeLengths({ from, to }: Tape): { length: number; across: number; down: number } {
  const across = Math.abs(to.x - from.x);
  const down = to.y - from.y;
  return { length: Math.round(Math.sqrt(across * across + down * down)), across, down };
}

/** What a tape says: its length in cm and squares, and, for a slanting one, how far across and down. */
export function tapeWords(t: TFunction, language: string, tape: Tape): string[] {
  const { length, across, down } = tapeLengths(tape);
  const squares = Math.round(length / (CELL / 10)) / 10;
  const words = [
    t("stage.measured.length", {
      cm: length,
      count: squares,
      squares: localNumber(String(squares), language),
    }),
  ];
  if (across > 0 && down !== 0) {
    const way = down > 0 ? "down" : "up";
    words.push(t(`stage.measured.${way}`, { across, along: Math.abs(down) }));
  }
  return words;
}
