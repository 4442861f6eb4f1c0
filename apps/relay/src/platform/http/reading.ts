/**
 * Reads and validates the parts of any request: bearer key, JSON body and the timeout of a long poll.
 */
import {
  MAX_FRAME_BYTES,
  problem,
  readJson,
  readValue,
  type FieldProblem,
} from "@corridor/protocol";
import express, { type Request, type RequestHandler, type Response } from "express";
import { z } from "zod";
import { badRequest, notJson, Refusal } from "../errors/problems.ts";
import { limits } from "../limits/limits.ts";
import type { WaitLimit } from "../time/wait-limit.ts";
import { clientName } from "./client-name.ts";

// Checks the text first, then the number, because /openapi.json describes the number.
export const waitError = `seconds to wait, from 0 to ${limits.longPollSeconds}`;
const seconds = z.number().min(0).max(limits.longPollSeconds, { error: waitError });
export const waitText = z
  .string({ error: waitError })
  .regex(/^\d{1,2}(\.\d{1,3})?$/, { error: waitError })
  .transform(Number)
  .pipe(seconds.multipleOf(0.001));
export const waitSchema = waitText
  .prefault("0")
  .describe(`${waitError}; the relay responds earlier if there is a result`);

const numberError = "a whole number of at most 15 digits";
export const wholeNumber = z
  .string({ error: numberError })
  .regex(/^\d{1,15}$/, { error: numberError })
  .transform(Number)
  .pipe(z.int().min(0).max(999_999_999_999_999));

export function read<T>(schema: z.ZodType<T>, input: unknown, what: string): T {
  const result = readValue(schema, input);
  if (!result.ok) throw badRequest(what, result.problems);
  return result.value;
}

/** `?seconds=S` of a response that only waits. */
export function readWaitSeconds(request: Request): number {
  const query = z.object({ seconds: waitText });
  return read(query, request.query, "Invalid query.").seconds;
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

// A lenient decoder would read a text other than the intended one.
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

/** How errors in a body are explained. */
export interface BodyHelp {
  /** a valid body, for a text that is not JSON */
  example?: string;
  /** replaces the problems by clearer ones. @param body parsed */
  clearer?: (body: unknown, problems: readonly FieldProblem[]) => FieldProblem[];
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
  { example, clearer }: BodyHelp = {},
): T {
  const body: unknown = request.body;
  const result =
    body === null
      ? problem("", "bytes that are not UTF-8", "a JSON document in UTF-8")
      : readJson(schema, typeof body === "string" ? body : "", maxLength);
  if (result.ok) return result.value;
  if (typeof body !== "string" || body.length > maxLength) throw badRequest(what, result.problems);
  const parsed = parse(body);
  if (parsed === null) throw notJson(what, example);
  throw badRequest(what, clearer?.(parsed.value, result.problems) ?? result.problems);
}

/** @returns null if the text is not JSON */
function parse(text: string): { value: unknown } | null {
  try {
    return { value: JSON.parse(text) };
  } catch {
    return null;
  }
}

/** Limits of a wait: the timeout, and a signal for when the client disconnects. */
export function waitLimitOf(response: Response, seconds: number): WaitLimit {
  const controller = new AbortController();
  response.once("close", () => controller.abort());
  return { milliseconds: seconds * 1000, signal: controller.signal };
}
