/**
 * Validates external input: takes JSON text or an unknown value, and returns a value or a list of
 * problems. Each problem names the field, the found value and the expected one, so that the page,
 * the command line and the relay show the same message.
 *
 * The `error` texts of all schemas contain the text for "expected".
 */
import { z } from "zod";

// By default zod compiles validators with `new Function`, which the page's Content Security Policy
// forbids. Programs without a page may set `jitless` to false before they create their first
// schema.
if (z.config().jitless === undefined) z.config({ jitless: true });

/** One error in a document. `path` is "" for the document itself. */
export interface FieldProblem {
  path: string;
  found: string;
  expected: string;
}

export type ReadResult<T> = { ok: true; value: T } | { ok: false; problems: FieldProblem[] };

/** Maximum number of listed problems. */
export const MAX_PROBLEMS = 20;
const MAX_FOUND_LENGTH = 60;

/**
 * Validates a parsed value.
 * @returns the output of the schema, or 1 to 20 problems
 */
export function readValue<T>(schema: z.ZodType<T>, input: unknown): ReadResult<T> {
  const result = schema.safeParse(input);
  if (result.success) return { ok: true, value: result.data };
  const problems = result.error.issues
    .slice(0, MAX_PROBLEMS)
    .flatMap((issue) => problemsOf(issue, input));
  return { ok: false, problems: problems.slice(0, MAX_PROBLEMS) };
}

/** JSON text as a value, or why it is none. */
export type ParsedJson =
  | { ok: true; value: unknown }
  | {
      ok: false;
      /** false: the text is not JSON; true: it is too long or repeats a field */
      isJson: boolean;
      problems: FieldProblem[];
    };

/**
 * Parses and validates JSON text. Rejects text that is too long before parsing it.
 * @param maxLength in UTF-16 code units
 */
export function readJson<T>(schema: z.ZodType<T>, text: string, maxLength: number): ReadResult<T> {
  const parsed = parseJson(text, maxLength);
  return parsed.ok ? readValue(schema, parsed.value) : { ok: false, problems: parsed.problems };
}

/** Parses JSON text, for callers that validate the value themselves. @param maxLength as above */
export function parseJson(text: string, maxLength: number): ParsedJson {
  if (text.length > maxLength) {
    const found = `${text.length} characters`;
    return { ...problem("", found, `at most ${maxLength} characters`), isJson: true };
  }
  let value: unknown;
  try {
    value = JSON.parse(text);
  } catch (error) {
    const reason = error instanceof Error ? error.message : "unreadable text";
    const found = shorten(`text that is not JSON: ${reason}`);
    return { ...problem("", found, "a JSON document"), isJson: false };
  }
  if (countKeys(text) !== countFields(value)) {
    const expected = "each field once";
    return { ...problem("", "a duplicate field in an object", expected), isJson: true };
  }
  return { ok: true, value };
}

const QUOTE = '"'.charCodeAt(0);
const BACKSLASH = "\\".charCodeAt(0);
const COLON = ":".charCodeAt(0);

/**
 * Number of keys in valid JSON text: each has one colon outside of strings. Needed because
 * `JSON.parse` silently drops all but the last of duplicate fields.
 */
function countKeys(text: string): number {
  let count = 0;
  let isInString = false;
  for (let i = 0; i < text.length; i++) {
    const character = text.charCodeAt(i);
    if (character === QUOTE) isInString = !isInString;
    else if (isInString && character === BACKSLASH) i++;
    else if (!isInString && character === COLON) count++;
  }
  return count;
}

/** Number of fields of all objects in a value. Not recursive, because senders choose the depth. */
function countFields(input: unknown): number {
  let count = 0;
  const open: unknown[] = [input];
  while (open.length > 0) {
    const value = open.pop();
    if (typeof value !== "object" || value === null) continue;
    const parts: unknown[] = Object.values(value);
    if (!Array.isArray(value)) count += parts.length;
    for (const part of parts) open.push(part);
  }
  return count;
}

/** A failed result with one problem, for checks outside of schemas. */
export function problem(
  path: string,
  found: string,
  expected: string,
): { ok: false; problems: FieldProblem[] } {
  return { ok: false, problems: [{ path, found, expected }] };
}

/**
 * The problem as one line of text: `rules[3].do: found "fly", expected one of forward, reverse`.
 */
export function describeProblem({ path, found, expected }: FieldProblem): string {
  return `${path === "" ? "document" : path}: found ${found}, expected ${expected}`;
}

/** A short description of a value, for "found". */
function describeValue(value: unknown): string {
  if (value === undefined) return "nothing";
  if (Array.isArray(value)) return `a list of ${value.length}`;
  if (typeof value === "object" && value !== null) return "an object";
  if (typeof value === "string") return JSON.stringify(shorten(value));
  return typeof value === "number" ? String(value) : JSON.stringify(value);
}

function problemsOf(issue: z.core.$ZodIssue, input: unknown): FieldProblem[] {
  if (issue.code === "unrecognized_keys") {
    return issue.keys.map((key) => ({
      path: pathText([...issue.path, key]),
      found: describeValue(valueAt(input, [...issue.path, key])),
      expected: "no field of this name",
    }));
  }
  return [
    {
      path: pathText(issue.path),
      found: describeValue(valueAt(input, issue.path)),
      expected: issue.message,
    },
  ];
}

function pathText(path: readonly PropertyKey[]): string {
  let text = "";
  for (const part of path) {
    if (typeof part === "number") text += `[${part}]`;
    else text += (text === "" ? "" : ".") + shorten(String(part));
  }
  return text;
}

function valueAt(input: unknown, path: readonly PropertyKey[]): unknown {
  let value = input;
  for (const part of path) {
    if (typeof value !== "object" || value === null) return undefined;
    value = Object.getOwnPropertyDescriptor(value, part)?.value;
  }
  return value;
}

function shorten(text: string): string {
  const clean = text.replaceAll("\n", " ");
  return clean.length > MAX_FOUND_LENGTH ? `${clean.slice(0, MAX_FOUND_LENGTH)}…` : clean;
}
