/** The challenge document, `corridor/challenge` version 1: one task. */
import { readJson, readValue, type ReadResult } from "@corridor/protocol";
import { z } from "zod";
import { MAX_CHALLENGE_TEXT_LENGTH, MAX_CHECK_SECONDS } from "./challenge-limits.ts";
import { allowedInChallenge, findContradictions, taskFields } from "./task-schema.ts";

const shape = z.strictObject(
  {
    format: z.literal("corridor/challenge", { error: '"corridor/challenge"' }),
    version: z.literal(1, { error: "version 1, the newest that this Corridor reads" }),
    ...taskFields(MAX_CHECK_SECONDS),
    allowed: allowedInChallenge,
  },
  { error: "a challenge: an object" },
);
export type ChallengeDocument = z.infer<typeof shape>;
export type ChallengeWords = ChallengeDocument["words"];

/** The schema with its cross-field rules. */
export const challengeSchema = shape.check(({ value, issues }) => {
  findContradictions(value, (path, message) => {
    issues.push({ code: "custom", path, message, input: value });
  });
});

/** Reads a challenge from a parsed value. */
export function parseChallenge(input: unknown): ReadResult<ChallengeDocument> {
  return readValue(challengeSchema, input);
}

/** Reads a challenge from JSON text. */
export function readChallenge(text: string): ReadResult<ChallengeDocument> {
  return readJson(challengeSchema, text, MAX_CHALLENGE_TEXT_LENGTH);
}
