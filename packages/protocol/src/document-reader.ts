/**
 * Reading what comes from outside: JSON text or an unknown value in, a checked value or a list of
 * problems out. Every problem names the field, what was found and what was expected, so that the
 * page, the command line and the relay can all say the same sentence.
 *
 * A schema in this project puts the words of "expected" into its `error` texts.
 */
import { z } from "zod";

// zod compiles validators with `new Function` unless told otherwise; the page forbids that (CSP). A program
// without a page may decide otherwise before it makes its first schema.
if (z.config().jitless === undefined) z.config({ jitless: true });

/** One thing that is wrong with a document. `path` is "" for the document itself. */
export interface FieldProblem {
  path: string;
  found: string;
  expected: string;
}

export type ReadResult<T> = { ok: true; value: T } | { ok: false; problems: FieldProblem[] };

/** No more problems than this are listed; a reader mends the first few and tries again. */
export const MAX_PROBLEMS = 20;
const MAX_FOUND_LENGTH = 60;

/**
 * Checks an already parsed value.
 * @returns the value as the schema gives it back, or 1 to 20 problems
 */
export function readValue<T>(schema: z.ZodType<T>, input: unknown): ReadResult<T> {
  const result = schema.safeParse(input);
  if (result.success) return { ok: true, value: result.data };
  const problems = result.error.issues
    .slice(0, MAX_PROBLEMS)
    .flatMap((issue) => problemsOf(issue, input));
  return { ok: false, problems: problems.slice(0, MAX_PROBLEMS) };
}

/**
 * Parses JSON text and checks it. The length is checked first, so that a huge text costs nothing.
 * @param maxLength in UTF-16 code units
 */
export function readJson<T>(schema: z.ZodType<T>, text: string, maxLength: number): ReadResult<T> {
  if (text.length > maxLength) {
    return problem("", `${text.length} characters`, `at most ${maxLength} characters`);
  }
  let input: unknown;
  try {
    input = JSON.parse(text);
  } catch (error) {
    const reason = error instanceof Error ? error.message : "unreadable text";
    return problem("", shorten(reason), "a JSON document");
  }
  if (countKeys(text) !== countFields(input)) {
    return problem("", "a field that stands twice in one object", "each field once");
  }
  return readValue(schema, input);
}

const QUOTE = '"'.charCodeAt(0);
const BACKSLASH = "\\".charCodeAt(0);
const COLON = ":".charCodeAt(0);

/**
 * Keys in a text that is known to be JSON: each has the one colon outside of texts. `JSON.parse` keeps
 * the last of two fields of one name and drops the other without a word.
 */
function countKeys(text: string): number {
  let count = 0;
  let isInText = false;
  for (let i = 0; i < text.length; i++) {
    const character = text.charCodeAt(i);
    if (character === QUOTE) isInText = !isInText;
    else if (isInText && character === BACKSLASH) i++;
    else if (!isInText && character === COLON) count++;
  }
  return count;
}

/** Fields of all objects in a parsed value. Not recursive: the depth is the sender's to choose. */
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

/** A failed result with one problem, for checks that no schema can express. */
export function problem(
  path: string,
  found: string,
  expected: string,
): { ok: false; problems: FieldProblem[] } {
  return { ok: false, problems: [{ path, found, expected }] };
}

/** The problem as one line: `rules[3].do: found "fly", expected one of forward, reverse`. */
export function describeProblem({ path, found, expected }: FieldProblem): string {
  return `${path === "" ? "document" : path}: found ${found}, expected ${expected}`;
}

/** A value in a few characters, for "found". */
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
