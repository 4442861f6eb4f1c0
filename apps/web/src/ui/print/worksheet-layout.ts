/** Places maze and empty lines on a worksheet. Pure. */
import { sheetOf, type PaperName, type Size } from "./paper.ts";

/** Edge of a worksheet, in millimetres. */
export const WORKSHEET_MARGIN = 14;
/** Height of one line to write on, in millimetres. */
export const LINE_HEIGHT = 10;
/** Height of the name, the task and the scale around the maze, in millimetres. */
const WORDS_HEIGHT = 66;
const FEWEST_LINES = 4;
const MOST_LINES = 10;
/** Largest printed square: a robot of paper fits into it, in millimetres. */
const LARGEST_SQUARE = 24;

export interface WorksheetLayout {
  isLandscape: boolean;
  sheet: Size;
  /** side of a square, in millimetres */
  square: number;
  /** to write on; the last one is "otherwise" */
  lines: number;
}

/**
 * Upright or on its side, whichever shows the larger maze.
 * @param mostLines lines of a program that the task allows; null: any number
 */
export function layOutWorksheet(
  { columns, rows }: { columns: number; rows: number },
  paper: PaperName,
  mostLines: number | null,
): WorksheetLayout {
  const [upright, lying] = [false, true].map((isLandscape) => {
    const sheet = sheetOf(paper, isLandscape);
    const room = {
      width: sheet.width - 2 * WORKSHEET_MARGIN,
      height: sheet.height - 2 * WORKSHEET_MARGIN - WORDS_HEIGHT,
    };
    const square = Math.min(
      LARGEST_SQUARE,
      room.width / columns,
      (room.height - FEWEST_LINES * LINE_HEIGHT) / rows,
    );
    const free = Math.floor((room.height - square * rows) / LINE_HEIGHT);
    // "Otherwise" has a line, too.
    const most = mostLines === null ? MOST_LINES : Math.min(MOST_LINES, mostLines + 1);
    const lines = Math.min(most, Math.max(FEWEST_LINES, free));
    return { isLandscape, sheet, square, lines };
  }) as [WorksheetLayout, WorksheetLayout];
  return lying.square > upright.square ? lying : upright;
}
