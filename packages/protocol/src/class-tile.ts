/**
 * The tile of a student: the complete current state, which the dashboard draws. A newer tile
 * replaces an older one, and the relay stores none. A tile is a claim of the student's page.
 */
import { z } from "zod";
import { countSchema, MAX_TASK_MAZES, taskNumberSchema, wholeNumber } from "./class-quantities.ts";
import { MAX_LENGTH } from "./quantities.ts";
import { lineSchema } from "./snapshot.ts";

/** Largest message with a tile, in UTF-16 code units. */
export const MAX_TILE_LENGTH = 1_024;
/** Longest path, in characters. */
const MAX_PATH = 400;

const lengthError = `cm from ${-MAX_LENGTH} to ${MAX_LENGTH}`;
const length = z
  .number({ error: lengthError })
  .min(-MAX_LENGTH, { error: lengthError })
  .max(MAX_LENGTH, { error: lengthError });
const headingError = "degrees clockwise from north, from 0 up to 360";
const heading = z
  .number({ error: headingError })
  .min(0, { error: headingError })
  .lt(360, { error: headingError });

const mazeError = "g and the number of a given maze, u and the number of an unseen one, or null";
const pathError = `moves such as e4s2, at most ${MAX_PATH} characters`;
const passesError = `a number of mazes from 0 to ${MAX_TASK_MAZES}, or null`;

export const tileStates = ["writing", "driving", "bumped", "solved"] as const;

export const tileSchema = z.strictObject({
  /** increases with each tile of a page */
  seq: countSchema,
  /** number of the open task, from 1 */
  task: taskNumberSchema,
  /**
   * the displayed maze of the task: given maze 1 is `g1`, unseen maze 31 is `u31`; null: another
   */
  maze: z
    .string({ error: mazeError })
    .regex(/^[gu][1-9]\d{0,3}$/, { error: mazeError })
    .nullable(),
  state: z.enum(tileStates, { error: `one of ${tileStates.join(", ")}` }),
  /** x and y in cm, and heading in degrees */
  pose: z.tuple([length, length, heading], { error: "a list of x, y and heading" }),
  /** the newest moves, in cells to the north, east, south and west */
  path: z
    .string({ error: pathError })
    .max(MAX_PATH, { error: pathError })
    .regex(/^(?:[news]\d{1,3})*$/, { error: pathError }),
  /** the line that decides now; null unless a program drives */
  line: lineSchema.nullable(),
  tick: countSchema,
  bumps: countSchema,
  /** number of mazes that pass in the newest check; null: no check */
  passes: wholeNumber(passesError, 0, MAX_TASK_MAZES).nullable(),
});
export type Tile = z.infer<typeof tileSchema>;
