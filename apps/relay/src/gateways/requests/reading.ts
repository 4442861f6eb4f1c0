/**
 * Validates the parts of a request: bearer key, JSON body, query and the timeout of a long poll.
 */
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
import { clientName } from "./client-name.ts";
import { badRequest, Refusal } from "../../platform/errors/problems.ts";
import { limits } from "../../platform/limits/limits.ts";
import type { Caller, Introduction } from "../../robots/access/caller.ts";
import type { ScriptTime } from "../../robots/delivery/script-clocks.ts";
import type { WaitLimit } from "../../robots/readers/subscribers.ts";

// Checks the text first, then the number, because /openapi.json describes the number.
const waitError = `seconds to wait, from 0 to ${limits.longPollSeconds}`;
const seconds = z.number().min(0).max(limits.longPollSeconds, { error: waitError });
const waitText = z
  .string({ error: waitError })
  .regex(/^\d{1,2}(\.\d{1,3})?$/, { error: waitError })
  .transform(Number)
  .pipe(seconds.multipleOf(0.001));
const waitSchema = waitText
  .prefault("0")
  .describe(`${waitError}; the relay responds earlier if there is a result`);

const numberError = "a whole number of at most 15 digits";
const wholeNumber = z
  .string({ error: numberError })
  .regex(/^\d{1,15}$/, { error: numberError })
  .transform(Number)
  .pipe(z.int().min(0).max(999_999_999_999_999));

/** Header for the name of a script. Characters outside of ASCII are percent-encoded. */
export const nameHeader = z.object({
  "Script-Name": z
    .string()
    .optional()
    .describe("name of the script, for the robot's owner; percent-encoded UTF-8"),
});
const clockError = "an id of 8 to 32 of A-Z a-z 0-9 - _, a space, and whole milliseconds";
/** Header for the time at which a script sent a request. */
export const clockHeader = z.object({
  "Script-Clock": z
    .string({ error: clockError })
    .regex(/^[A-Za-z0-9_-]{8,32} \d{1,15}$/, { error: clockError })
    .optional()
    .describe(
      "`ID MILLISECONDS`: a random id of the script's monotonic clock, and the time of that clock at sending; " +
        "the transit time of a command then counts towards its ttl",
    ),
});
/** `?wait=S` for the record of a command */
export const waitQuery = z.object({ wait: waitSchema });
/** `?after=SEQ&wait=S` for snapshots; without `after`, any snapshot is returned */
export const newerQuery = z.object({
  after: wholeNumber.optional().describe("seq of the last received snapshot"),
  wait: waitSchema,
});
/** `?since=STREAM-n&after=SEQ&wait=S` for events */
export const eventsQuery = z.object({
  since: sinceSchema.optional().describe("the last received event: STREAM-n"),
  after: wholeNumber
    .optional()
    .describe("with `wait`: also respond if there is a snapshot with a higher seq"),
  wait: waitText
    .optional()
    .describe(`${waitError}, for one response in JSON; without it, an endless stream`),
});
/** Header of an event stream that reconnects. */
export const lastEventHeader = z.object({
  "Last-Event-ID": sinceSchema
    .optional()
    .describe("the id of the last received event; `since` takes precedence"),
});
/** `?after=NUMBER&wait=S` for the messages of a long-poll connection */
export const fetchQuery = z.object({
  after: wholeNumber.prefault("0").describe("number of the last received message"),
  wait: waitSchema,
});
/** `?after=SEQ` for the log */
export const logQuery = z.object({
  after: wholeNumber.prefault("0").describe("seq of the last received command"),
});
/** The number of a command, as the last segment of a path. */
export const seqPath = z.object({ seq: wholeNumber.describe("number of the command") });
/** Header that makes a command safe to retry. */
export const idempotencyHeader = z.object({
  "Idempotency-Key": idempotencyKeySchema
    .optional()
    .describe("makes a retry safe; use a new key for each command"),
});

export function read<T>(schema: z.ZodType<T>, input: unknown, what: string): T {
  const result = readValue(schema, input);
  if (!result.ok) throw badRequest(what, result.problems);
  return result.value;
}

/** Query of a request that only has a wait. */
export function readWait(request: Request): { wait: number } {
  return read(waitQuery, request.query, "Invalid query.");
}

/** Query for a snapshot. */
export function readNewer(request: Request): { after?: number | undefined; wait: number } {
  return read(newerQuery, request.query, "Invalid query.");
}

/** Query for events. A stream that reconnects sends its position in a header. */
export function readEvents(request: Request): z.infer<typeof eventsQuery> {
  const header = { "Last-Event-ID": request.get("Last-Event-ID") };
  const { "Last-Event-ID": last } = read(lastEventHeader, header, "Invalid header.");
  const query = { ...(last !== undefined && { since: last }), ...request.query };
  return read(eventsQuery, query, "Invalid query.");
}

/** `?seconds=S` of a response that only waits. */
export function readWaitSeconds(request: Request): number {
  const query = z.object({ seconds: waitText });
  return read(query, request.query, "Invalid query.").seconds;
}

/** Query for the messages of a long-poll connection. */
export function readFetch(request: Request): z.infer<typeof fetchQuery> {
  return read(fetchQuery, request.query, "Invalid query.");
}

/** Query for the log. */
export function readAfter(request: Request): { after: number } {
  return read(logQuery, request.query, "Invalid query.");
}

/** Number of a command in the path. */
export function readSeq(text: unknown): number {
  return read(seqPath, { seq: text }, "Invalid path.").seq;
}

/** Key of `Authorization: Bearer KEY`, or null. */
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

/** How a script identifies itself in its headers. */
export function readIntroduction(request: Request): Introduction {
  const sent = request.get("Script-Name");
  return {
    client: readClient(request),
    name: sent === undefined ? null : scriptName(percentDecode(sent)),
  };
}

/** Time at which a script sent the request, by its own clock, or null. */
export function readScriptTime(request: Request): ScriptTime | null {
  const given = { "Script-Clock": request.get("Script-Clock") };
  const { "Script-Clock": text } = read(clockHeader, given, "Invalid header.");
  if (text === undefined) return null;
  const [clock = "", sentAt] = text.split(" ");
  return { clock, sentAt: Number(sentAt) };
}

/**
 * Percent-decodes a header, which is limited to ASCII. A text with a lone % is returned unchanged.
 */
function percentDecode(text: string): string {
  try {
    return decodeURIComponent(text);
  } catch {
    return text;
  }
}

// A lenient decoder would store a name other than the intended one.
const utf8 = new TextDecoder("utf-8", { fatal: true });

/**
 * Reads the body as text. Errors go to the error handler: not JSON, not UTF-8 or too large.
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

/** @returns null if the bytes are not UTF-8 */
function textOf(bytes: Buffer): string | null {
  try {
    return utf8.decode(bytes);
  } catch {
    return null;
  }
}

/** @param type content type of the body; JSON without a charset is UTF-8 */
function isJson(type: string): boolean {
  const [name = "", ...parameters] = type.toLowerCase().split(";");
  const charset = parameters.map((text) => text.trim()).find((text) => text.startsWith("charset="));
  const isUtf8 = charset === undefined || /^charset="?utf-?8"?$/.test(charset);
  return name.trim() === "application/json" && isUtf8;
}

/**
 * Parses and validates the body.
 * @param what sentence for the error, such as "Invalid command."
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

/** Command in the body with its terms, and the idempotency key in the header. */
export function readCommandRequest(request: Request): { key: string | null } & CommandTerms {
  const order = readBody(request, orderSchema, MAX_FRAME_BYTES, "Invalid command.");
  return { key: readIdempotencyKey(request), ...termsOf(order) };
}

/** Header Idempotency-Key, or null. */
export function readIdempotencyKey(request: Request): string | null {
  const given = { "Idempotency-Key": request.get("Idempotency-Key") };
  return read(idempotencyHeader, given, "Invalid header.")["Idempotency-Key"] ?? null;
}

/**
 * Limits of a wait: the timeout, and a signal for when the client disconnects. A revoked key also
 * ends it.
 */
export function waitLimitOf(response: Response, seconds: number, key?: Caller): WaitLimit {
  const controller = new AbortController();
  response.once("close", () => controller.abort());
  const waitLimit = { milliseconds: seconds * 1000, signal: controller.signal };
  return key === undefined ? waitLimit : { ...waitLimit, key };
}
