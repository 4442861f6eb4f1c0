/**
 * The program document, `corridor/program` version 1: a default action and an ordered list of
 * rules.
 */
import {
  plainActions,
  readJson,
  readValue,
  ruleConditionSchema,
  type ReadResult,
  type RuleCondition,
} from "@corridor/protocol";
import { z } from "zod";
import { MAX_NAME_LENGTH, MAX_RULES } from "./vocabulary.ts";

/** Compares a sensor with a number, or left with right plus a number (Figure 15). */
export type Condition = RuleCondition;

const action = z.enum(plainActions, { error: `one of ${plainActions.join(", ")}` });

const rule = z.strictObject(
  { when: ruleConditionSchema.nullable(), do: action },
  { error: 'a rule: {"when": ..., "do": ...}' },
);
export type Rule = z.infer<typeof rule>;

export const programSchema = z.strictObject(
  {
    format: z.literal("corridor/program", { error: '"corridor/program"' }),
    version: z.literal(1, { error: "version 1, the newest that this Corridor reads" }),
    name: z
      .string({ error: `a name of at most ${MAX_NAME_LENGTH} characters` })
      .max(MAX_NAME_LENGTH, { error: `a name of at most ${MAX_NAME_LENGTH} characters` }),
    default: action,
    rules: z
      .array(rule, { error: "a list of rules" })
      .max(MAX_RULES, { error: `at most ${MAX_RULES} rules` }),
  },
  { error: "a program: an object" },
);
export type ProgramDocument = z.infer<typeof programSchema>;

/** Maximum text length in characters: the largest valid document plus indentation. */
const MAX_TEXT_LENGTH = 65_536;

/** Reads a program from a parsed value. */
export function parseProgram(input: unknown): ReadResult<ProgramDocument> {
  return readValue(programSchema, input);
}

/** Reads a program from JSON text. */
export function readProgram(text: string): ReadResult<ProgramDocument> {
  return readJson(programSchema, text, MAX_TEXT_LENGTH);
}
