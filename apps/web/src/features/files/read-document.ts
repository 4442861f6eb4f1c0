/**
 * Detects what a text is by its content, and reads it: a document of Corridor, or a maze drawn as
 * text.
 */
import { readLesson, type LessonDocument } from "@corridor/challenge";
import { isContestText, readMaze, readTextMaze, type MazeDocument } from "@corridor/maze";
import { readProgram, type ProgramDocument } from "@corridor/program";
import type { FieldProblem, ReadResult } from "@corridor/protocol";
import { readRun, type RunDocument } from "@corridor/recording";
import { looksLikeProgram } from "./looks-like-file.ts";

const SAVED_PROGRAM = 'a program as Corridor saves it: {"format":"corridor/program", ...}';

export type OpenedDocument =
  /** `isContest`: in a format of contests */
  | { kind: "maze"; maze: MazeDocument; isContest?: true }
  | { kind: "program"; program: ProgramDocument }
  | { kind: "run"; run: RunDocument }
  | { kind: "lesson"; lesson: LessonDocument };

const readers = new Map<string, (text: string) => ReadResult<OpenedDocument>>([
  [
    "corridor/maze",
    (text) => {
      const read = readMaze(text);
      return read.ok ? { ok: true, value: { kind: "maze", maze: read.value } } : read;
    },
  ],
  [
    "corridor/program",
    (text) => {
      const read = readProgram(text);
      return read.ok ? { ok: true, value: { kind: "program", program: read.value } } : read;
    },
  ],
  [
    "corridor/run",
    (text) => {
      const read = readRun(text);
      return read.ok ? { ok: true, value: { kind: "run", run: read.value } } : read;
    },
  ],
  [
    "corridor/challenge",
    (text) => {
      const read = readLesson(text);
      return read.ok ? { ok: true, value: { kind: "lesson", lesson: read.value } } : read;
    },
  ],
]);

/**
 * Reads one text.
 * @param name name for a maze that has none
 * @returns the document, or its problems
 */
export function readDocument(text: string, name: string): ReadResult<OpenedDocument> {
  const content = text.replace(/^\uFEFF/, "");
  if (isContestText(content)) {
    const read = readTextMaze(content, name);
    return read.ok
      ? { ok: true, value: { kind: "maze", maze: read.value, isContest: true } }
      : read;
  }
  if (!/^\s*[{[]/.test(content)) {
    if (looksLikeProgram(content)) {
      const [line = ""] = content.trim().split("\n", 1);
      return refuse("", JSON.stringify(line.slice(0, 80).trim()), SAVED_PROGRAM);
    }
    const read = readTextMaze(content, name);
    return read.ok ? { ok: true, value: { kind: "maze", maze: read.value } } : read;
  }
  // Documents that Corridor writes start with their format, so they are parsed only once.
  const named = readers.get(/^\s*\{\s*"format"\s*:\s*"([a-z/]+)"/.exec(content)?.[1] ?? "");
  if (named !== undefined) return named(content);
  let input: unknown;
  try {
    input = JSON.parse(content);
  } catch (error) {
    return refuse("", error instanceof Error ? error.message : "broken text", "a JSON document");
  }
  const format: unknown =
    typeof input === "object" && input !== null && "format" in input ? input.format : undefined;
  const reader = typeof format === "string" ? readers.get(format) : undefined;
  if (reader !== undefined) return reader(content);
  const known = [...readers.keys()].map((each) => JSON.stringify(each));
  const found = format === undefined ? "nothing" : JSON.stringify(format);
  return refuse("format", found, `one of ${known.join(", ")}`);
}

/** Removes the endings of a file name: "my-maze.maze.json" becomes "my-maze". */
export function titleOf(file: string): string {
  return file.replace(/(\.[\p{Letter}\p{Number}]{1,8}){1,2}$/u, "");
}

function refuse(
  path: string,
  found: string,
  expected: string,
): { ok: false; problems: FieldProblem[] } {
  return { ok: false, problems: [{ path, found: found.slice(0, 120), expected }] };
}
