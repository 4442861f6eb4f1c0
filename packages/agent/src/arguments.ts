/** Arguments of the tools. Their descriptions teach an agent, so that it needs no other page. */
import {
  actionNames,
  commandRecordSchema,
  idempotencyKeySchema,
  snapshotSchema,
  TTL_MS,
  untilSchema,
} from "@corridor/protocol";
import { z } from "zod";

/** Longest wait of one call, in seconds: clients and proxies end longer requests. */
export const MAX_WAIT_SECONDS = 25;

const until = untilSchema.optional();

const key = idempotencyKeySchema
  .optional()
  .describe(
    "8 to 64 of A-Z a-z 0-9 _ -, a new one for each command, also in a new conversation. Repeat it only to try the same command again: the robot then does not move twice.",
  );

export const noArguments = z.strictObject({});

export const lookArguments = z.strictObject({
  picture: z
    .boolean({ error: "true or false" })
    .optional()
    .describe("true: also return the maze as a PNG picture"),
});

const secondsError = `seconds from 0 to ${MAX_WAIT_SECONDS}`;

export const waitArguments = z.strictObject({
  seconds: z
    .number({ error: secondsError })
    .min(0, { error: secondsError })
    .max(MAX_WAIT_SECONDS, { error: secondsError })
    .optional()
    .describe(`how long to wait at most; default: ${MAX_WAIT_SECONDS}`),
  until: until.describe(
    "return as soon as one of these conditions is true; {goal: true}: the robot has reached a goal since its start",
  ),
});

export const resetArguments = z.strictObject({ key });

/** Shape of a command, for clients. The port checks commands by the schema of the API. */
export const actArguments = z.strictObject({
  action: z.enum(actionNames),
  distance: z.number().optional().describe("move: cm, negative is backward"),
  degrees: z.number().optional().describe("turn: degrees, negative is left"),
  left: z.number().optional().describe("drive: power of the left wheel, -1 to 1"),
  right: z.number().optional().describe("drive: power of the right wheel, -1 to 1"),
  milliseconds: z.number().optional().describe("drive: for how long, not together with until"),
  until: until.describe(
    "forward, reverse, drive: the motion ends on the first tick on which one of these conditions is true; {goal: true}: the whole robot stands in a goal cell",
  ),
  ttl: z
    .number()
    .optional()
    .describe(`milliseconds within which the command must start; default: ${TTL_MS.default}`),
  replace: z
    .boolean()
    .optional()
    .describe("true: end earlier commands first; otherwise wait for their end"),
  key,
});

export const snapshotResult = z.looseObject({ snapshot: snapshotSchema.loose() });

/** Without the fields of each action, which agents know from the arguments. */
const sentCommand = z.looseObject({ action: z.string() });

export const commandResult = z.looseObject({
  record: commandRecordSchema.extend({ command: sentCommand }).loose(),
  snapshot: snapshotSchema.loose().nullable().describe("null before the robot's first report"),
});

export const waitResult = z.looseObject({
  condition: z
    .int()
    .nullable()
    .describe("index in until of the first true condition; null: none is true"),
  snapshot: snapshotSchema.loose(),
});

const cell = { column: z.int(), row: z.int() };

export const lookResult = z.looseObject({
  name: z.string(),
  columns: z.int(),
  rows: z.int(),
  blocks: z.array(z.string()).describe("one text a row, # block, . open"),
  start: z.looseObject({ ...cell, heading: z.string() }),
  goals: z.array(z.looseObject(cell)),
  robot: z
    .looseObject({ ...cell, heading: z.number() })
    .nullable()
    .describe("the cell in which its centre is; null before its first report"),
});
