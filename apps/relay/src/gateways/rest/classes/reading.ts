/** Reads the bodies and paths of requests on classes. */
import { challengeOrLessonSchema } from "@corridor/challenge/document";
import {
  classFields,
  classIdSchema,
  joinRequestSchema,
  MAX_DOCUMENT_BYTES,
  paceSchema,
  pauseRequestSchema,
} from "@corridor/protocol";
import { z } from "zod";
import { bodyReader, read, wholeNumber } from "../../../platform/http/reading.ts";

export const classRequestSchema = z.strictObject({
  ...classFields,
  lesson: challengeOrLessonSchema,
});
export const classPath = z.object({ id: classIdSchema });
export const studentPath = z.object({
  ...classPath.shape,
  student: wholeNumber.describe("number of the student"),
});

export const readClassRequest = bodyReader(classRequestSchema, "Invalid class.", {
  limit: MAX_DOCUMENT_BYTES,
});
export const readLessonBody = bodyReader(challengeOrLessonSchema, "Invalid lesson.", {
  limit: MAX_DOCUMENT_BYTES,
});
export const readJoin = bodyReader(joinRequestSchema, "Invalid code.", {
  example: '{"code":"BCDFGH"}',
});
export const readPause = bodyReader(pauseRequestSchema, "Invalid pause.", {
  example: '{"seconds":300}',
});
export const readPace = bodyReader(paceSchema, "Invalid pace.", { example: '{"to":2}' });

/** Number of a student in the path. */
export function readStudent(text: unknown): number {
  const path = z.object({ student: studentPath.shape.student });
  return read(path, { student: text }, "Invalid path.").student;
}
