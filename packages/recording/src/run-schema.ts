/** Parses run documents and checks their bounds and shape. `openRun` checks the run itself. */
import { mazeSchema } from "@corridor/maze";
import { programSchema } from "@corridor/program";
import {
  commandSchema,
  driverSchema,
  MAX_PROBLEMS,
  readJson,
  readValue,
  type ReadResult,
} from "@corridor/protocol";
import { z } from "zod";
import type { RunDocument } from "./run-document.ts";
import type { TimedInput } from "./run-input.ts";
import {
  MAX_RUN_INPUTS,
  MAX_RUN_NAME_LENGTH,
  MAX_RUN_TEXT_LENGTH,
  MAX_RUN_TICKS,
} from "./run-limits.ts";

const nameError = `a name of at most ${MAX_RUN_NAME_LENGTH} characters`;
const ticksError = `a whole number of ticks from 0 to ${MAX_RUN_TICKS}, 24 hours`;
const tickError =
  "a tick: a whole number from 0 to the run's ticks, none smaller than the one before";
const seqError = "the number of a command: a whole number from 1";
const supersededError = "true, or no such field";
const kinds = ["driver", "command", "cancel", "program", "maze"] as const;

const tick = z
  .int({ error: tickError })
  .min(0, { error: tickError })
  .max(MAX_RUN_TICKS, { error: tickError });

const input = z.discriminatedUnion(
  "do",
  [
    z.strictObject({ tick, do: z.literal("driver"), driver: driverSchema }),
    z.strictObject({
      tick,
      do: z.literal("command"),
      command: commandSchema,
      seq: z
        .int({ error: seqError })
        .min(1, { error: seqError })
        .max(Number.MAX_SAFE_INTEGER, { error: seqError })
        .optional(),
    }),
    z.strictObject({
      tick,
      do: z.literal("cancel"),
      superseded: z.literal(true, { error: supersededError }).optional(),
    }),
    z.strictObject({ tick, do: z.literal("program"), program: programSchema }),
    z.strictObject({ tick, do: z.literal("maze"), maze: mazeSchema }),
  ],
  { error: `one of ${kinds.join(", ")}` },
);

/** Stops after `MAX_PROBLEMS`, because reporting 100,000 bad inputs takes seconds. */
const inputs = z
  .array(z.unknown(), { error: 'a list of inputs: {"tick": ..., "do": ..., ...}' })
  .max(MAX_RUN_INPUTS, { error: `at most ${MAX_RUN_INPUTS} inputs` })
  .transform((given, context) => {
    const read: TimedInput[] = [];
    for (const [index, each] of given.entries()) {
      const result = input.safeParse(each);
      if (result.success) {
        read.push(result.data);
        continue;
      }
      for (const issue of result.error.issues) {
        const placed = { ...issue, path: [index, ...issue.path], input: each };
        context.issues.push(placed as z.core.$ZodRawIssue);
      }
      if (context.issues.length >= MAX_PROBLEMS) return z.NEVER;
    }
    return read;
  });

const runSchema: z.ZodType<RunDocument> = z
  .strictObject(
    {
      format: z.literal("corridor/run", { error: '"corridor/run"' }),
      version: z.literal(1, { error: "version 1, the newest that this Corridor reads" }),
      name: z.string({ error: nameError }).max(MAX_RUN_NAME_LENGTH, { error: nameError }),
      maze: mazeSchema,
      program: programSchema,
      seed: z.literal(0, { error: "0: nothing in a run of version 1 is random" }),
      ticks: z
        .int({ error: ticksError })
        .min(0, { error: ticksError })
        .max(MAX_RUN_TICKS, { error: ticksError }),
      inputs,
      digest: z
        .string({ error: "a digest: 16 hexadecimal digits" })
        .regex(/^[0-9a-f]{16}$/, { error: "a digest: 16 hexadecimal digits" }),
    },
    { error: "a run: an object" },
  )
  .check((context) => {
    const { ticks } = context.value;
    let before = 0;
    for (const [index, each] of context.value.inputs.entries()) {
      if (context.issues.length >= MAX_PROBLEMS) return;
      if (each.tick < before || each.tick > ticks) {
        context.issues.push({
          code: "custom",
          path: ["inputs", index, "tick"],
          message: tickError,
          input: context.value,
        });
      }
      before = each.tick;
    }
  });

/** Reads a run from a parsed value. */
export function parseRun(value: unknown): ReadResult<RunDocument> {
  return readValue(runSchema, value);
}

/** Reads a run from JSON text. */
export function readRun(text: string): ReadResult<RunDocument> {
  return readJson(runSchema, text, MAX_RUN_TEXT_LENGTH);
}
