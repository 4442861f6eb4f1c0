/** Numbers in the messages of a class, with their bounds. */
import { z } from "zod";

/** Highest student number: numbers of removed students are not assigned again. */
const MAX_STUDENT_NUMBER = 9_999;
/** Bounds of a lesson, from the document's schema in another package. */
const MAX_TASKS = 12;
const MAX_HINTS = 6;
/** Longest completion code, in characters. */
export const MAX_CODE = 4_096;

/** Given and unseen mazes of one task. */
export const MAX_TASK_MAZES = 1_010;

/** A whole number with one message for all of its bounds. */
export function wholeNumber(error: string, min: number, max: number) {
  return z.int({ error }).min(min, { error }).max(max, { error });
}

/** A number that every language represents exactly. */
export const countSchema = z
  .int({ error: "a whole number" })
  .min(0, { error: "0 or more" })
  .max(Number.MAX_SAFE_INTEGER, { error: "a whole number below 2^53" });

/** Numbers a student of its class: 1, 2, 3, ... */
export const studentNumberSchema = wholeNumber(
  `the number of a student, from 1 to ${MAX_STUDENT_NUMBER}`,
  1,
  MAX_STUDENT_NUMBER,
);

/** Numbers a task of the lesson: 1, 2, 3, ... */
export const taskNumberSchema = wholeNumber(
  `the number of a task, from 1 to ${MAX_TASKS}`,
  1,
  MAX_TASKS,
);

/** Numbers a hint of a task: 1, 2, 3, ... */
export const hintNumberSchema = wholeNumber(
  `the number of a hint, from 1 to ${MAX_HINTS}`,
  1,
  MAX_HINTS,
);
