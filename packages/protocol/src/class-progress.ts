/**
 * Progress of a student: numbered records of what happened, as the student's page reports it. The
 * relay stores them with its own time, until the class ends.
 */
import { z } from "zod";
import {
  hintNumberSchema,
  MAX_CODE,
  MAX_TASK_MAZES,
  taskNumberSchema,
  wholeNumber,
} from "./class-quantities.ts";
import { tileSchema } from "./class-tile.ts";
import { lineSchema } from "./snapshot.ts";

/** Records of one student. At most one in two seconds, so they last for almost three hours. */
export const MAX_PROGRESS = 5_000;
const MAX_QUESTIONS = 8;
const MAX_LINES = 200;
const MAX_COUNT = 1_000_000;
const MAX_CELL = 999;
/** Bumps of one run whose places are stored. */
export const MAX_BUMP_PLACES = 20;

function numberTo(max: number, min: 0 | 1) {
  return wholeNumber(`a whole number from ${min} to ${max}`, min, max);
}

const task = taskNumberSchema.describe("number of the task, from 1");
const markError = "the mark of a lesson: 9 hexadecimal digits";
const lessonMark = z
  .string({ error: markError })
  .regex(/^[0-9a-f]{9}$/, { error: markError })
  .describe("mark of the lesson, as completion codes contain it");
const count = numberTo(MAX_COUNT, 0);
const codeError = "the name of a failure, such as not-reached";
/** Why an attempt failed, and the line that caused it. */
export const attemptFailureSchema = z.strictObject(
  {
    code: z
      .string({ error: codeError })
      .regex(/^[a-z][a-z-]{0,31}$/, { error: codeError })
      .describe("as the check names it"),
    line: lineSchema.nullable().describe("null: no line caused it"),
  },
  { error: "a failure: an object, or null" },
);
const failure = attemptFailureSchema.nullable().describe("null: the attempt did not fail");
const changed = z
  .boolean({ error: "true or false" })
  .describe("whether the program differs from that of the last run or check");

const cell = numberTo(MAX_CELL, 0);
const placesError = `a list of at most ${MAX_BUMP_PLACES} places`;
const bumpPlaceSchema = z.strictObject(
  {
    maze: tileSchema.shape.maze.unwrap().describe("as in tiles"),
    column: cell,
    row: cell,
  },
  { error: "a place: a maze, a column and a row" },
);

const bumpPlaces = z
  .array(bumpPlaceSchema, { error: placesError })
  .max(MAX_BUMP_PLACES, { error: placesError })
  .optional();

const questionError = "the id of a question";
const answerError = "an answer from 1 (no help) to 5 (very helpful), or null";
export const surveyAnswerSchema = z.strictObject({
  id: z.string({ error: questionError }).regex(/^[a-z][a-z0-9_]{0,31}$/, { error: questionError }),
  answer: wholeNumber(answerError, 1, 5)
    .nullable()
    .describe("from 1 (no help) to 5 (very helpful); null: skipped"),
});

const answersError = `a list of at most ${MAX_QUESTIONS} answers`;
const answers = z
  .array(surveyAnswerSchema, { error: answersError })
  .max(MAX_QUESTIONS, { error: answersError });
const completionCodeError = `a completion code of at most ${MAX_CODE} characters`;

/** What happened. */
export const progressSchema = z.discriminatedUnion(
  "kind",
  [
    /** the records after it belong to this lesson */
    z.strictObject({ kind: z.literal("opened"), lesson: lessonMark, task }),
    z.strictObject({
      kind: z.literal("run"),
      task,
      changed,
      bumps: count,
      bumpPlaces: bumpPlaces.describe("cells of the first bumps in mazes of the task"),
      /** mistakes that the diagnosis found */
      mistakes: count,
      failure,
    }),
    z.strictObject({
      kind: z.literal("check"),
      task,
      changed,
      /** number of mazes that passed, and of all mazes, given and unseen */
      passes: numberTo(MAX_TASK_MAZES, 0),
      mazes: numberTo(MAX_TASK_MAZES, 1),
      bumpPlaces: bumpPlaces.describe("the cell of the bump that is the failure"),
      failure,
    }),
    z.strictObject({ kind: z.literal("hint"), task, hint: hintNumberSchema }),
    z.strictObject({
      kind: z.literal("solved"),
      task,
      /** of the program; null: the commands of a drive */
      lines: numberTo(MAX_LINES, 0).nullable(),
      /**
       * link section 3, by which the dashboard runs the attempt again: `solved` is a claim. null: a
       * drive that is too long for a code, or that a program drove in part
       */
      code: z
        .string({ error: completionCodeError })
        .min(1, { error: completionCodeError })
        .max(MAX_CODE, { error: completionCodeError })
        .nullable(),
    }),
    z.strictObject({ kind: z.literal("survey"), answers }),
  ],
  { error: "one of opened, run, check, hint, solved, survey" },
);
export type Progress = z.infer<typeof progressSchema>;

/** The number of a record of its student: 1, 2, 3, ... */
export const progressSeqSchema = numberTo(MAX_PROGRESS, 1);

/** A record as the relay stores it. */
export const progressRecordSchema = z.strictObject({
  seq: progressSeqSchema,
  /** by the relay's clock */
  at: z.iso.datetime(),
  /** ms since the class was created, without its pauses */
  activeMs: z.int().min(0),
  event: progressSchema,
});
export type ProgressRecord = z.infer<typeof progressRecordSchema>;
