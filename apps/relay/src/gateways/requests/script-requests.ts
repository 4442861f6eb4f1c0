/**
 * Requests of scripts and viewers of a robot: authorises them, and reads their queries and headers.
 */
import {
  idempotencyKeySchema,
  orderSchema,
  scriptName,
  sinceSchema,
  termsOf,
  type CommandTerms,
  type Snapshot,
} from "@corridor/protocol";
import type { Request, Response } from "express";
import { z } from "zod";
import {
  bodyReader,
  read,
  readClient,
  waitError,
  waitLimitOf,
  waitSchema,
  waitText,
  wholeNumber,
  readBearer,
} from "../../platform/http/reading.ts";
import { onClose } from "../../platform/http/on-close.ts";
import { Refusal } from "../../platform/errors/problems.ts";
import type { Caller, Introduction, Verb } from "../../robots/access/callers.ts";
import type { ScriptTime } from "../../robots/delivery/script-clocks.ts";
import type { CallerWait } from "../../robots/readers/subscribers.ts";
import { withCommandHint } from "./command-hints.ts";
import type { Grant, RobotRegistry } from "../../robots/registry.ts";

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

const readOrder = bodyReader(orderSchema, "Invalid command.", {
  example: '{"action":"left 90"}',
  clearer: withCommandHint,
});

/** Command in the body with its terms, and the idempotency key in the header. */
export async function readCommandRequest(
  request: Request,
  response: Response,
): Promise<{ key: string | null } & CommandTerms> {
  const order = await readOrder(request, response);
  return { key: readIdempotencyKey(request), ...termsOf(order) };
}

/** Header Idempotency-Key, or null. */
export function readIdempotencyKey(request: Request): string | null {
  const given = { "Idempotency-Key": request.get("Idempotency-Key") };
  return read(idempotencyHeader, given, "Invalid header.")["Idempotency-Key"] ?? null;
}

/** Reads a command. If it is invalid, the robot's owner sees why. */
export async function readFor<T>(
  { robot, caller }: Grant,
  reading: () => T | Promise<T>,
): Promise<T> {
  try {
    return await reading();
  } catch (error) {
    if (error instanceof Refusal) robot.refused(caller, error);
    throw error;
  }
}

/**
 * The newest snapshot, immediately or by waiting for one that is newer than `after`.
 * @throws Refusal no-snapshot before the robot's first report
 */
export async function readSnapshot(
  { robot, caller }: Grant,
  { after = -1, wait }: { after?: number | undefined; wait: number },
  response: Response,
): Promise<Snapshot> {
  const limit = callerWaitOf(response, wait, caller);
  const snapshot = await robot.readers.nextSnapshot(after, limit);
  if (snapshot !== null) return snapshot;
  throw new Refusal(
    "no-snapshot",
    "The robot's page has not reported yet. Open the page and connect it under Remote. With a wait of 25 seconds this request waits for the report.",
  );
}

/** Limits of a wait by a caller. A revoked key also ends it. */
export function callerWaitOf(response: Response, seconds: number, caller: Caller): CallerWait {
  return { ...waitLimitOf(response, seconds), key: caller };
}

export interface AuthorisedRequest extends Grant {
  /**
   * ms since the request was sent: the time since its arrival, and what it took longer than the
   * fastest one of its script (0 without a timestamp)
   */
  ageMs: () => number;
  /** ends the activity of the script before the response ends */
  markAnswered: () => void;
}

/** @throws Refusal with the same errors as `RobotRegistry.authorise` */
export async function authoriseScript(
  registry: RobotRegistry,
  request: Request<{ id: string }>,
  response: Response,
  verb: Verb,
): Promise<AuthorisedRequest> {
  const arrivedAt = registry.clock.now();
  const grant = await registry.authorise(
    request.params.id,
    readBearer(request),
    verb,
    readIntroduction(request),
  );
  const { robot, caller } = grant;
  const transitMs = robot.scriptClocks.measure(caller.hash, readScriptTime(request), arrivedAt);
  const markAnswered = robot.received(caller);
  onClose(response, markAnswered);
  const ageMs = (): number => transitMs + registry.clock.now() - arrivedAt;
  return { ...grant, ageMs, markAnswered };
}
