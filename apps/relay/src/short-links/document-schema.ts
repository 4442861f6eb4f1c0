/**
 * Schemas of the documents that a short link can store. The page validates with the same schemas.
 */
import { challengeSchema } from "@corridor/challenge/document";
import { mazeSchema } from "@corridor/maze";
import { programSchema } from "@corridor/program";
import { z } from "zod";

const error =
  'a document whose format is "corridor/maze", "corridor/program" or "corridor/challenge"';

export const documentSchema = z.discriminatedUnion(
  "format",
  [mazeSchema, programSchema, challengeSchema],
  { error },
);
export type SharedDocument = z.infer<typeof documentSchema>;
