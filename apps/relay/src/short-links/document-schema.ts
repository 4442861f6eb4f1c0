/**
 * Schemas of the documents that a short link can store. The page validates with the same schemas.
 */
import { challengeOrLessonSchema } from "@corridor/challenge/document";
import { projectSchema } from "@corridor/link/project";
import { mazeSchema } from "@corridor/maze";
import { programSchema } from "@corridor/program";
import { z } from "zod";

const error =
  'a document whose format is "corridor/maze", "corridor/program", "corridor/project" or "corridor/challenge"';

export const documentSchema = z.discriminatedUnion(
  "format",
  [mazeSchema, programSchema, projectSchema, challengeOrLessonSchema],
  { error },
);
export type SharedDocument = z.infer<typeof documentSchema>;
