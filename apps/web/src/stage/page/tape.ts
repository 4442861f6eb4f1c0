/** The measuring tape between two points of the maze, in whole centimetres. Pure. */
import { CELL, type Cell } from "@corridor/maze";
import type { TFunction } from "i18next";
import type { Layout } from "../drawing/viewport.ts";
import { localNumber } from "../../text/numbers.ts";

/** A point of the maze, in whole centimetres. */
export interface TapePoint {
  x: number;
  y: number;
}

export interface Tape {
  from: TapePoint;
  to: TapePoint;
  /** whether the second point is not placed yet */
  isOpen: boolean;
}

export function middleOf({ column, row }: Cell): TapePoint {
  return { x: (column + 0.5) * CELL, y: (row + 0.5) * CELL };
}

/** The square that contains a point. */
export function cellAtPoint({ x, y }: TapePoint): Cell {
  return { column: Math.floor(x / CELL), row: Math.floor(y / CELL) };
}

/**
 * The nearest point of the maze.
 * @param x pixels from the left edge of the maze
 * @param y pixels from the top edge of the maze
 */
export function tapePointAt(layout: Layout, x: number, y: number): TapePoint {
  const along = (pixels: number, cells: number): number =>
    Math.min(cells * CELL, Math.max(0, Math.round((pixels * CELL) / layout.cellPx)));
  return { x: along(x, layout.columns), y: along(y, layout.rows) };
}

/**
 * Length, width and height of a tape in centimetres, with a rounded length; `down` is negative
 * upward.
 */
export function tapeLengths({ from, to }: Tape): { length: number; across: number; down: number } {
  const across = Math.abs(to.x - from.x);
  const down = to.y - from.y;
  return { length: Math.round(Math.sqrt(across * across + down * down)), across, down };
}

/**
 * The labels of a tape: its length in cm and squares, and for a slanting tape its width and height.
 */
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
    const direction = down > 0 ? "down" : "up";
    words.push(t(`stage.measured.${direction}`, { across, along: Math.abs(down) }));
  }
  return words;
}
