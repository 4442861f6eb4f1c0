/**
 * The program document, `corridor/program` version 1: a default action and an ordered list of
 * rules.
 */
import {
  sensorNames,
  plainActions,
  readJson,
  readValue,
  type ReadResult,
} from "@corridor/protocol";
import { z } from "zod";
import { MAX_NAME_LENGTH, MAX_PLUS, MAX_RULES, MAX_THAN } from "./vocabulary.ts";

const than = z
  .number({ error: `a number from 0 to ${MAX_THAN}` })
  .min(0, { error: `a number from 0 to ${MAX_THAN}` })
  .max(MAX_THAN, { error: `a number from 0 to ${MAX_THAN}` });

const plus = z
  .number({ error: `a number from ${-MAX_PLUS} to ${MAX_PLUS}` })
  .min(-MAX_PLUS, { error: `a number from ${-MAX_PLUS} to ${MAX_PLUS}` })
  .max(MAX_PLUS, { error: `a number from ${-MAX_PLUS} to ${MAX_PLUS}` });

const comparator = z.enum([">", "<"], { error: 'one of ">", "<"' });

const conditionError = 'a condition: {"sensor": ..., "is": ..., "than": ...} or null';

const againstNumber = z.strictObject(
  {
    sensor: z.enum(sensorNames, { error: `one of ${sensorNames.join(", ")}` }),
    is: comparator,
    than,
  },
  { error: conditionError },
);

const againstRight = z.strictObject({
  sensor: z.literal("left", { error: '"left", when it is compared with "right"' }),
  is: comparator,
  than: z.literal("right"),
  plus,
});

/** Compares a sensor with a number, or left with right plus a number (Figure 15). */
export type Condition = z.infer<typeof againstNumber> | z.infer<typeof againstRight>;

// Not z.union, whose errors name no field. `than` selects the schema.
const condition = z
  .unknown()
  .transform((input, context): Condition => {
    const isAgainstRight =
      typeof input === "object" && input !== null && "than" in input && input.than === "right";
    const result = (isAgainstRight ? againstRight : againstNumber).safeParse(input);
    if (result.success) return result.data;
    for (const issue of result.error.issues) {
      const fields = issue.code === "unrecognized_keys" ? issue.keys : [undefined];
      for (const field of fields) {
        context.issues.push({
          code: "custom",
          input,
          path: field === undefined ? issue.path : [...issue.path, field],
          message: field === undefined ? issue.message : "no field of this name",
        });
      }
    }
    return z.NEVER;
    // The output schema lets generators of API descriptions read the shape.
  })
  .pipe(z.union([againstNumber, againstRight]));

const action = z.enum(plainActions, { error: `one of ${plainActions.join(", ")}` });

const rule = z.strictObject(
  { when: condition.nullable(), do: action },
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
