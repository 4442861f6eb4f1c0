/** Reads documents from files and reports all problems of all files together. */
import { readFileSync, statSync } from "node:fs";
import { parse } from "node:path";
import { type MazeDocument } from "@corridor/maze";
import { readProgram, type ProgramDocument } from "@corridor/program";
import {
  describeProblem,
  problem,
  readJson,
  timedCommandsSchema,
  type ReadResult,
  type TimedCommand,
} from "@corridor/protocol";
import { InputError } from "./input-error.ts";
import { readMazeBytes } from "./read-maze-bytes.ts";
import { readUtf8 } from "./read-utf8.ts";

/** Larger than any valid document. */
export const MAX_BYTES = 16 * 1024 * 1024;

/** Paths of files by the type of their documents. */
export interface Files {
  mazes: readonly string[];
  programs: readonly string[];
  commands?: readonly string[];
}

/** The documents of `Files`, in the same order. */
export interface Documents {
  mazes: MazeDocument[];
  programs: ProgramDocument[];
  commands: TimedCommand[][];
}

/** Reads all files. @throws InputError with every problem of every file */
export function readFiles({ mazes, programs, commands = [] }: Files): Documents {
  const lines: string[] = [];
  const documents = {
    mazes: readAll(mazes, readMazeFile, lines),
    programs: readAll(programs, (file) => readFile(file, readProgram), lines),
    commands: readAll(commands, (file) => readFile(file, readCommands), lines),
  };
  if (lines.length > 0) throw new InputError(lines);
  return documents;
}

function readCommands(text: string): ReadResult<TimedCommand[]> {
  return readJson(timedCommandsSchema, text, MAX_BYTES);
}

function readAll<T>(
  files: readonly string[],
  read: (file: string) => ReadResult<T>,
  lines: string[],
): T[] {
  return files.flatMap((file) => {
    const result = read(file);
    if (result.ok) return [result.value];
    lines.push(...result.problems.map((each) => `${file}: ${describeProblem(each)}`));
    return [];
  });
}

/** Reads a maze in any format. A file without a name gives its own to the maze. */
function readMazeFile(file: string): ReadResult<MazeDocument> {
  const bytes = bytesOf(file);
  return bytes.ok ? readMazeBytes(bytes.value, parse(file).name) : bytes;
}

/** Reads one file as UTF-8. @param read reads the document from the text of the file */
export function readFile<T>(file: string, read: (text: string) => ReadResult<T>): ReadResult<T> {
  const bytes = bytesOf(file);
  return bytes.ok ? readUtf8(bytes.value, read) : bytes;
}

function bytesOf(file: string): ReadResult<Uint8Array> {
  try {
    const { size } = statSync(file);
    if (size > MAX_BYTES) return problem("", `${size} bytes`, `at most ${MAX_BYTES} bytes`);
    return { ok: true, value: readFileSync(file) };
  } catch (error) {
    return problem("", reasonOf(error), "a readable file");
  }
}

/** Describes why a file cannot be read or written. */
export function reasonOf(error: unknown): string {
  const code = error instanceof Error && "code" in error ? error.code : undefined;
  switch (code) {
    case "ENOENT":
      return "no file of this name";
    case "EISDIR":
      return "a folder";
    case "EACCES":
      return "a file without permission";
    default:
      return error instanceof Error ? error.message : "no file";
  }
}
