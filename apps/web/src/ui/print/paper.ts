/** Paper sizes and the parts of a printed sheet, in millimetres. */

export const papers = {
  a4: { width: 210, height: 297 },
  letter: { width: 215.9, height: 279.4 },
} as const;

export type PaperName = keyof typeof papers;

export interface Size {
  width: number;
  height: number;
}

/** A sheet as it is read: upright or on its side. */
export function sheetOf(paper: PaperName, isLandscape: boolean): Size {
  const { width, height } = papers[paper];
  return isLandscape ? { width: height, height: width } : { width, height };
}

/** Edge that printers leave empty. */
export const MARGIN = 10;
/** Room below the maze for the ruler and the place of the sheet. */
export const RULER_ROOM = 14;
/** Common part of two neighbouring sheets, for the glue. */
export const OVERLAP = 10;
/** Length of the ruler: 10 cm. */
export const RULER = 100;
