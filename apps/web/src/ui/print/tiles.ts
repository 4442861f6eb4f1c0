/** Divides a maze, at a given size of its squares, into sheets that are glued together. Pure. */
import { MARGIN, OVERLAP, RULER_ROOM, sheetOf, type PaperName, type Size } from "./paper.ts";

/** More sheets are hours of glueing. */
export const MAX_SHEETS = 60;
/** Side of a printed square, in centimetres. */
export const squareBounds = { min: 1, max: 50 };
/** Steps in which a smaller square is proposed, in centimetres. */
const SQUARE_STEP = 0.5;
/** Room for the line around the maze, in millimetres. */
export const FRAME = 2;
const MM_PER_CM = 10;

interface Cells {
  columns: number;
  rows: number;
}

/** Sheets in a grid. Each shows the part of the maze that starts at (x, y), in millimetres. */
export interface Tiling {
  ok: true;
  isLandscape: boolean;
  /** number of sheets side by side, and one below the other */
  columns: number;
  rows: number;
  /** the part of the maze on one sheet */
  part: Size;
  sheets: readonly { column: number; row: number; x: number; y: number }[];
}

/** `most`: the largest square that fits, in centimetres; null if none does. */
export interface TooManySheets {
  ok: false;
  sheets: number;
  most: number | null;
}

/** @param square side of a printed square, in centimetres */
export function tileMaze(maze: Cells, square: number, paper: PaperName): Tiling | TooManySheets {
  const upright = gridOf(maze, square, paper, false);
  const lying = gridOf(maze, square, paper, true);
  const isLandscape = lying.columns * lying.rows < upright.columns * upright.rows;
  const { columns, rows, part } = isLandscape ? lying : upright;
  const count = columns * rows;
  if (count > MAX_SHEETS)
    return { ok: false, sheets: count, most: largestSquare(maze, square, paper) };
  const sheets = Array.from({ length: count }, (_, at) => {
    const [column, row] = [at % columns, Math.floor(at / columns)];
    return {
      column,
      row,
      x: column * (part.width - OVERLAP),
      y: row * (part.height - OVERLAP),
    };
  });
  return { ok: true, isLandscape, columns, rows, part, sheets };
}

/** Size of the printed maze with its frame, in millimetres. */
export function printedSize({ columns, rows }: Cells, square: number): Size {
  const side = square * MM_PER_CM;
  return { width: columns * side + 2 * FRAME, height: rows * side + 2 * FRAME };
}

function gridOf(maze: Cells, square: number, paper: PaperName, isLandscape: boolean) {
  const sheet = sheetOf(paper, isLandscape);
  const part = {
    width: sheet.width - 2 * MARGIN,
    height: sheet.height - 2 * MARGIN - RULER_ROOM,
  };
  const whole = printedSize(maze, square);
  const along = (length: number, room: number) =>
    Math.max(1, Math.ceil((length - OVERLAP) / (room - OVERLAP)));
  return {
    columns: along(whole.width, part.width),
    rows: along(whole.height, part.height),
    part,
  };
}

function largestSquare(maze: Cells, square: number, paper: PaperName): number | null {
  const steps = Math.floor((square - squareBounds.min) / SQUARE_STEP);
  for (let step = steps; step >= 0; step--) {
    const smaller = squareBounds.min + step * SQUARE_STEP;
    const fits = [false, true].some((isLandscape) => {
      const { columns, rows } = gridOf(maze, smaller, paper, isLandscape);
      return columns * rows <= MAX_SHEETS;
    });
    if (smaller < square && fits) return smaller;
  }
  return null;
}
