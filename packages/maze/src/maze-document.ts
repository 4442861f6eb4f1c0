/**
 * The maze document, `corridor/maze` version 1: rows of cells, a start and goals.
 * A cell is 100 x 100 units. The area outside the grid is solid.
 */
import { readJson, readValue, type ReadResult } from "@corridor/protocol";
import { z } from "zod";
import { BLOCK, headingNames, MAX_GOALS, MAX_NAME_LENGTH, MAX_SIDE } from "./maze-limits.ts";

const rowsError = `1 to ${MAX_SIDE} rows, each a text of # and .`;
const rowError = `a row of 1 to ${MAX_SIDE} characters, # for a block and . for an open cell`;
const indexError = `a whole number from 0 to ${MAX_SIDE - 1}`;

const row = z
  .string({ error: rowError })
  .max(MAX_SIDE, { error: rowError })
  .regex(/^[#.]+$/, { error: rowError });

const index = z
  .int({ error: indexError })
  .min(0, { error: indexError })
  .max(MAX_SIDE - 1, { error: indexError });

const cell = z.strictObject(
  { column: index, row: index },
  { error: 'a cell: {"column": ..., "row": ...}' },
);
/** A cell of the grid. `column` and `row` start at 0 in the top-left corner. */
export type Cell = z.infer<typeof cell>;

const start = z.strictObject(
  {
    column: index,
    row: index,
    heading: z.enum(headingNames, { error: `one of ${headingNames.join(", ")}` }),
  },
  { error: 'a start: {"column": ..., "row": ..., "heading": ...}' },
);
export type Start = z.infer<typeof start>;

const shape = z.strictObject(
  {
    format: z.literal("corridor/maze", { error: '"corridor/maze"' }),
    version: z.literal(1, { error: "version 1, the newest that this Corridor reads" }),
    name: z
      .string({ error: `a name of at most ${MAX_NAME_LENGTH} characters` })
      .max(MAX_NAME_LENGTH, { error: `a name of at most ${MAX_NAME_LENGTH} characters` }),
    blocks: z
      .array(row, { error: rowsError })
      .min(1, { error: rowsError })
      .max(MAX_SIDE, { error: rowsError }),
    start,
    goals: z
      .array(cell, { error: "a list of cells" })
      .max(MAX_GOALS, { error: `at most ${MAX_GOALS} goals` }),
  },
  { error: "a maze: an object" },
);
export type MazeDocument = z.infer<typeof shape>;

/**
 * The schema with its cross-field rules: all rows have the same length, and the start and the goals
 * are open cells inside the grid.
 */
export const mazeSchema = shape.check((context) => {
  const { blocks, start: from, goals } = context.value;
  const width = blocks[0]?.length ?? 0;
  const refuse = (path: (string | number)[], message: string): void => {
    context.issues.push({ code: "custom", path, message, input: context.value });
  };
  for (const [number, text] of blocks.entries()) {
    if (text.length !== width) {
      refuse(["blocks", number], `${width} characters, as in the first row`);
    }
  }
  const checkOpen = (at: Cell, path: (string | number)[]): void => {
    if (at.row >= blocks.length) {
      refuse([...path, "row"], `a row inside the maze, at most ${blocks.length - 1}`);
    } else if (at.column >= width) {
      refuse([...path, "column"], `a column inside the maze, at most ${width - 1}`);
    } else if (blocks[at.row]?.[at.column] === BLOCK) {
      refuse(path, "an open cell, not a block");
    }
  };
  checkOpen(from, ["start"]);
  for (const [number, goal] of goals.entries()) checkOpen(goal, ["goals", number]);
});

/** Maximum text length in characters: the largest valid document plus indentation. */
const MAX_TEXT_LENGTH = 262_144;

/** Reads a maze from a parsed value. */
export function parseMaze(input: unknown): ReadResult<MazeDocument> {
  return readValue(mazeSchema, input);
}

/** Reads a maze from JSON text. */
export function readMaze(text: string): ReadResult<MazeDocument> {
  return readJson(mazeSchema, text, MAX_TEXT_LENGTH);
}
