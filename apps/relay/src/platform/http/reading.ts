/**
 * Reads and validates the parts of any request: bearer key, JSON body and the timeout of a long poll.
 */
import type { IncomingMessage } from "node:http";
import { MAX_FRAME_BYTES, parseJson, readValue, type FieldProblem } from "@corridor/protocol";
import express, { type Request, type Response } from "express";
import { z } from "zod";
import { badRequest, notJson, Refusal } from "../errors/problems.ts";
import { limits } from "../limits/limits.ts";
import type { WaitLimit } from "../time/wait-limit.ts";
import { clientName } from "./client-name.ts";
import { closeSignal } from "./on-close.ts";

// Checks the text first, then the number, because /openapi.json describes the number.
export const waitError = `seconds to wait, from 0 to ${limits.longPollSeconds}`;
export const waitSeconds = z
  .number({ error: waitError })
  .min(0, { error: waitError })
  .max(limits.longPollSeconds, { error: waitError });
export const waitText = z
  .string({ error: waitError })
  .regex(/^\d{1,2}(\.\d{1,3})?$/, { error: waitError })
  .transform(Number)
  .pipe(waitSeconds.multipleOf(0.001));
export const waitSchema = waitText
  .prefault("0")
  .describe(`${waitError}; the relay responds earlier if there is a result`);

const numberError = "a whole number of at most 15 digits";
export const countSchema = z
  .int({ error: numberError })
  .min(0, { error: numberError })
  .max(999_999_999_999_999, { error: numberError });
export const wholeNumber = z
  .string({ error: numberError })
  .regex(/^\d{1,15}$/, { error: numberError })
  .transform(Number)
  .pipe(countSchema);

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
export function readBearer({ headers }: IncomingMessage): string | null {
  const header = headers.authorization ?? "";
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
 * Creates a function that receives the body of a request as text.
 * @param limit maximum length in bytes
 * @returns the function; its text is null if the body is not UTF-8, and it throws an error of Express
 * if the body is too large
 */
export function textReader(
  limit: number,
): (request: Request, response: Response) => Promise<string | null> {
  const receive = express.raw({ type: () => true, limit, inflate: false });
  return async (request, response) => {
    await new Promise<void>((resolve, reject) => {
      receive(request, response, (error?: unknown) =>
        error === undefined ? resolve() : reject(error),
      );
    });
    const bytes: unknown = request.body;
    return Buffer.isBuffer(bytes) ? textOf(bytes) : "";
  };
}

/** How a body is read, and how its errors are explained. */
export interface BodyOptions {
  /** maximum length in bytes */
  limit?: number;
  /** a valid body, for a text that is not JSON */
  example?: string;
  /** replaces the problems by clearer ones. @param body parsed */
  clearer?: (body: unknown, problems: readonly FieldProblem[]) => FieldProblem[];
}

/**
 * Creates a function that reads, parses and validates the body of a request. Routes authorise a
 * request before they call it, so that the relay does not read the body of a stranger.
 * @param what sentence for the error, such as "Invalid command."
 * @returns the function; it throws a Refusal, or an error of Express if the body is too large
 */
export function bodyReader<T>(
  schema: z.ZodType<T>,
  what: string,
  { limit = MAX_FRAME_BYTES, example, clearer }: BodyOptions = {},
): (request: Request, response: Response) => Promise<T> {
  const readText = textReader(limit);
  return async (request, response) => {
    requireJson(request);
    const text = await readText(request, response);
    if (text === null) {
      const expected = "a JSON document in UTF-8";
      throw badRequest(what, [{ path: "", found: "bytes that are not UTF-8", expected }]);
    }
    const parsed = parseJson(text, limit);
    if (!parsed.ok) {
      throw parsed.isJson ? badRequest(what, parsed.problems) : notJson(what, text, example);
    }
    const { value } = parsed;
    const result = readValue(schema, value);
    if (result.ok) return result.value;
    throw badRequest(what, clearer?.(value, result.problems) ?? result.problems);
  };
}

/** @throws Refusal if the content type is not JSON in UTF-8 */
function requireJson(request: Request): void {
  const { name, isUtf8 } = mediaTypeOf(request.headers["content-type"] ?? "");
  if (name === "application/json" && isUtf8) return;
  throw new Refusal(
    "not-json",
    'Send the body as JSON in UTF-8, with the header "Content-Type: application/json".',
  );
}

/** @returns null if the bytes are not UTF-8 */
function textOf(bytes: Buffer): string | null {
  try {
    return utf8.decode(bytes);
  } catch {
    return null;
  }
}

/** The content type of a body. Without a charset it is UTF-8. */
export function mediaTypeOf(type: string): { name: string; isUtf8: boolean } {
  const [name = "", ...parameters] = type.toLowerCase().split(";");
  const charset = parameters.map((text) => text.trim()).find((text) => text.startsWith("charset="));
  const isUtf8 = charset === undefined || /^charset="?utf-?8"?$/.test(charset);
  return { name: name.trim(), isUtf8 };
}

/** Limits of a wait: the timeout, and a signal for when the client disconnects. */
export function waitLimitOf(response: Response, seconds: number): WaitLimit {
  return { milliseconds: seconds * 1000, signal: closeSignal(response) };
}
