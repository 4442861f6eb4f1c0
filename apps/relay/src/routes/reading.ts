/** What a request carries, checked: bearer key, JSON body, query, patience for a long poll. */
import {
  idempotencyKeySchema,
  MAX_FRAME_BYTES,
  orderSchema,
  problem,
  readJson,
  readValue,
  scriptName,
  sinceSchema,
  termsOf,
  type CommandTerms,
} from "@corridor/protocol";
import express, { type Request, type RequestHandler, type Response } from "express";
import { z } from "zod";
import { clientName } from "../client-name.ts";
import { badRequest, Refusal } from "../problems.ts";
import { limits } from "../sessions/limits.ts";
import type { Caller, Introduction } from "../sessions/script.ts";
import type { ScriptTime } from "../sessions/script-clocks.ts";
import type { Patience } from "../sessions/audience.ts";

// First the text is checked, then the number that it stands for: /openapi.json describes the number.
const waitError = `seconds to wait, from 0 to ${limits.longPollSeconds}`;
const seconds = z.number().min(0).max(limits.longPollSeconds, { error: waitError });
const waitText = z
  .string({ error: waitError })
  .regex(/^\d{1,2}(\.\d{1,3})?$/, { error: waitError })
  .transform(Number)
  .pipe(seconds.multipleOf(0.001));
const waitSchema = waitText
  .prefault("0")
  .describe(`${waitError}; the answer comes at once when it is there`);

const numberError = "a whole number of at most 15 digits";
const wholeNumber = z
  .string({ error: numberError })
  .regex(/^\d{1,15}$/, { error: numberError })
  .transform(Number)
  .pipe(z.int().min(0).max(999_999_999_999_999));

/** The header by which a script gives its name; other letters than ASCII percent-encoded. */
export const nameHeader = z.object({
  "Script-Name": z
    .string()
    .optional()
    .describe("what the script calls itself, for the robot's owner; percent-encoded UTF-8"),
});
const clockError = "an id of 8 to 32 of A-Z a-z 0-9 - _, a space, and whole milliseconds";
/** The header by which a script says when it sent a request. */
export const clockHeader = z.object({
  "Script-Clock": z
    .string({ error: clockError })
    .regex(/^[A-Za-z0-9_-]{8,32} \d{1,15}$/, { error: clockError })
    .optional()
    .describe(
      "`ID MILLISECONDS`: a random id of the script's monotonic clock, and when it sent the request by that clock; " +
        "the time that a command spends on its way then counts for its time to live",
    ),
});
/** `?wait=S` of a command's record */
export const waitQuery = z.object({ wait: waitSchema });
/** `?after=SEQ&wait=S` of snapshots; without `after` any snapshot will do */
export const newerQuery = z.object({
  after: wholeNumber.optional().describe("seq of the newest snapshot that is known already"),
  wait: waitSchema,
});
/** `?since=STREAM-n&after=SEQ&wait=S` of events */
export const eventsQuery = z.object({
  since: sinceSchema.optional().describe("the last state that is known: STREAM-n"),
  after: wholeNumber
    .optional()
    .describe("with `wait`: also answer when there is a snapshot with a higher seq"),
  wait: waitText
    .optional()
    .describe(`${waitError}, for one answer in JSON; without it, a stream without end`),
});
/** The header of an event stream that comes back. */
export const lastEventHeader = z.object({
  "Last-Event-ID": sinceSchema
    .optional()
    .describe("the id of the last event that is known; `since` counts more"),
});
/** `?after=NUMBER&wait=S` of a line's messages */
export const fetchQuery = z.object({
  after: wholeNumber.prefault("0").describe("number of the last message that has come"),
  wait: waitSchema,
});
/** `?after=SEQ` of the log */
export const logQuery = z.object({
  after: wholeNumber.prefault("0").describe("seq of the last command that is known already"),
});
/** The number of a command, as the last part of a path. */
export const seqPath = z.object({ seq: wholeNumber.describe("number of the command") });
/** The header of a command that may be sent twice. */
export const idempotencyHeader = z.object({
  "Idempotency-Key": idempotencyKeySchema
    .optional()
    .describe("makes a retry safe; a new one for each command"),
});

export function read<T>(schema: z.ZodType<T>, input: unknown, what: string): T {
  const result = readValue(schema, input);
  if (!result.ok) throw badRequest(what, result.problems);
  return result.value;
}

/** The wait of a call that has no other query. */
export function readWait(request: Request): { wait: number } {
  return read(waitQuery, request.query, "The query is wrong.");
}

/** Which snapshot is wanted, and for how long to wait for it. */
export function readNewer(request: Request): { after?: number | undefined; wait: number } {
  return read(newerQuery, request.query, "The query is wrong.");
}

/** Which events are wanted, and how. An event stream that comes back says in a header where it was. */
export function readEvents(request: Request): z.infer<typeof eventsQuery> {
  const header = { "Last-Event-ID": request.get("Last-Event-ID") };
  const { "Last-Event-ID": last } = read(lastEventHeader, header, "The request is wrong.");
  const query = { ...(last !== undefined && { since: last }), ...request.query };
  return read(eventsQuery, query, "The query is wrong.");
}

/** The `?seconds=S` of an answer that only takes its time. */
export function readWaitSeconds(request: Request): number {
  const query = z.object({ seconds: waitText });
  return read(query, request.query, "The query is wrong.").seconds;
}

/** Which messages of a line are wanted, and for how long to wait for them. */
export function readFetch(request: Request): z.infer<typeof fetchQuery> {
  return read(fetchQuery, request.query, "The query is wrong.");
}

/** From where on the log is wanted. */
export function readAfter(request: Request): { after: number } {
  return read(logQuery, request.query, "The query is wrong.");
}

/** The number of a command in the path. */
export function readSeq(text: unknown): number {
  return read(seqPath, { seq: text }, "The path is wrong.").seq;
}

/** The key of `Authorization: Bearer KEY`; null when there is none. */
export function readBearer(request: Request): string | null {
  const header = request.get("authorization") ?? "";
  const space = header.indexOf(" ");
  if (space < 0 || header.slice(0, space).toLowerCase() !== "bearer") return null;
  return header.slice(space + 1).trim();
}

/** The script's language, for the page. */
export function readClient(request: Request): string {
  return clientName(request.get("user-agent"));
}

/** What a script says of itself in its headers. */
export function readIntroduction(request: Request): Introduction {
  const sent = request.get("Script-Name");
  return {
    client: readClient(request),
    name: sent === undefined ? null : scriptName(decoded(sent)),
  };
}

/** When a script sent the request, by its own clock; null where it does not say. */
export function readScriptTime(request: Request): ScriptTime | null {
  const given = { "Script-Clock": request.get("Script-Clock") };
  const { "Script-Clock": text } = read(clockHeader, given, "The request is wrong.");
  if (text === undefined) return null;
  const [clock = "", sentAt] = text.split(" ");
  return { clock, sentAt: Number(sentAt) };
}

/** Headers hold ASCII only, so other letters are percent-encoded; a lone % stands for itself. */
function decoded(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

// A decoder that mends wrong bytes would store another name than the one that was meant.
const utf8 = new TextDecoder("utf-8", { fatal: true });

/**
 * Takes the body in as text; what is not JSON in UTF-8 or too large is refused by the error handler.
 * @param limit in bytes
 */
export function jsonText(limit: number = MAX_FRAME_BYTES): RequestHandler {
  const bytes = express.raw({ type: () => true, limit, inflate: false });
  return (request, response, next) => {
    if (!isJson(request.headers["content-type"] ?? "")) {
      throw new Refusal(
        "not-json",
        'Send the body as JSON in UTF-8, with the header "Content-Type: application/json".',
      );
    }
    bytes(request, response, (error?: unknown) => {
      if (error === undefined && Buffer.isBuffer(request.body)) request.body = textOf(request.body);
      next(error);
    });
  };
}

/** @returns null for bytes that are no text */
function textOf(bytes: Buffer): string | null {
  try {
    return utf8.decode(bytes);
  } catch {
    return null;
  }
}

/** @param type of the body: JSON, which is UTF-8 even where nothing is said */
function isJson(type: string): boolean {
  const [name = "", ...parameters] = type.toLowerCase().split(";");
  const charset = parameters.map((text) => text.trim()).find((text) => text.startsWith("charset="));
  const isUtf8 = charset === undefined || /^charset="?utf-?8"?$/.test(charset);
  return name.trim() === "application/json" && isUtf8;
}

/**
 * What the body holds.
 * @param what a sentence for when it breaks the schema, such as "The command is wrong."
 */
export function readBody<T>(
  request: Request,
  schema: z.ZodType<T>,
  maxLength: number,
  what: string,
): T {
  const body: unknown = request.body;
  const result =
    body === null
      ? problem("", "bytes that are not UTF-8", "a JSON document in UTF-8")
      : readJson(schema, typeof body === "string" ? body : "", maxLength);
  if (!result.ok) throw badRequest(what, result.problems);
  return result.value;
}

/** The command in the body with its terms, and the idempotency key in the header. */
export function readCommandRequest(request: Request): { key: string | null } & CommandTerms {
  const order = readBody(request, orderSchema, MAX_FRAME_BYTES, "The command is wrong.");
  return { key: readIdempotencyKey(request), ...termsOf(order) };
}

/** The header Idempotency-Key; null when there is none. */
export function readIdempotencyKey(request: Request): string | null {
  const given = { "Idempotency-Key": request.get("Idempotency-Key") };
  return read(idempotencyHeader, given, "The request is wrong.")["Idempotency-Key"] ?? null;
}

/** Waits as long as asked, or until the client hangs up, or its key is revoked. */
export function patienceOf(response: Response, seconds: number, key?: Caller): Patience {
  const controller = new AbortController();
  response.once("close", () => controller.abort());
  const patience = { milliseconds: seconds * 1000, signal: controller.signal };
  return key === undefined ? patience : { ...patience, key };
}
