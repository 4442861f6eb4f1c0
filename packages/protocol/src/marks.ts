/**
 * Marks that a script draws over the cells of the maze: a text, a colour and the walls that it assumes.
 * They are not stored, and end with the script.
 */
import { z } from "zod";

/** Cells of one message, so that the largest message fits into a frame. */
export const MAX_MARKED_CELLS = 128;
const MAX_TEXT = 10;
const MAX_INDEX = 255;

export const markColors = [
  "black",
  "blue",
  "gray",
  "cyan",
  "green",
  "orange",
  "red",
  "white",
  "yellow",
  "dark-blue",
  "dark-cyan",
  "dark-gray",
  "dark-green",
  "dark-orange",
  "dark-red",
  "dark-violet",
  "dark-yellow",
] as const;
export type MarkColor = (typeof markColors)[number];

const indexError = `a whole number from 0 to ${MAX_INDEX}`;
const index = z
  .int({ error: indexError })
  .min(0, { error: indexError })
  .max(MAX_INDEX, { error: indexError });
const textError = `at most ${MAX_TEXT} printable ASCII characters`;
const wallsError = "some of n, e, s and w, in this order";

/** The marks of one cell. They replace its earlier ones. */
export const cellMarkSchema = z.strictObject({
  /** the block in the middle of the cell */
  column: index,
  row: index,
  text: z
    .string({ error: textError })
    .max(MAX_TEXT, { error: textError })
    .regex(/^[ -~]*$/, { error: textError }),
  color: z.enum(markColors, { error: `null, or one of ${markColors.join(", ")}` }).nullable(),
  /** sides of the cell with an assumed wall */
  walls: z.string({ error: wallsError }).regex(/^n?e?s?w?$/, { error: wallsError }),
});
export type CellMark = z.infer<typeof cellMarkSchema>;

const cellsError = `at most ${MAX_MARKED_CELLS} cells`;

/** Fields of the message `marks`, in all directions. */
export const marksFields = {
  /** whether all earlier marks are removed first */
  fresh: z.boolean({ error: "true or false" }),
  /** blocks of a cell along one side: 2 in a maze of posts and walls, whose walls are blocks */
  pitch: z.union([z.literal(1), z.literal(2)], { error: "1 or 2" }),
  /** the cells that have changed */
  cells: z
    .array(cellMarkSchema, { error: cellsError })
    .max(MAX_MARKED_CELLS, { error: cellsError }),
};

export interface Marks {
  fresh: boolean;
  pitch: 1 | 2;
  cells: CellMark[];
}
