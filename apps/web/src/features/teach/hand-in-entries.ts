/** The hand-ins of the teacher: files, and links or codes on lines of text. */
import { isProgram, type Attempt, type LessonDocument, type LessonTask } from "@corridor/challenge";
import { handInsOf, readHandInFile, type HandIn, type HandInRefusal } from "@corridor/link";
import type { FieldProblem } from "@corridor/protocol";
import { MAX_FILE_BYTES } from "./lessons/read-lesson.ts";
import type { TextFile } from "../../ui/incoming-files.ts";

/** Why a hand-in is not checked. */
export interface HandInProblem {
  code:
    | HandInRefusal
    /** a completion code of a task that is not chosen */
    | "other-task"
    | "file-size"
    | "file-unreadable";
  problems: readonly FieldProblem[];
  /** the sentence of `grade`, in English, for the CSV */
  problem: string;
}

export type ReadHandIn = { ok: true; value: HandIn } | ({ ok: false } & HandInProblem);

export interface HandInFile {
  name: string;
  read: ReadHandIn;
}

/** A hand-in of the list that is checked. */
export interface HandInEntry {
  /** name of the file, or number of the line */
  source: { file: string } | { line: number };
  read: ReadHandIn;
}

/** Maximum number of hand-ins in one check. */
export const MAX_HAND_INS = 500;

/** Reads files; each file that cannot be read has its problem. */
export async function readHandInFiles(files: readonly TextFile[]): Promise<HandInFile[]> {
  const read: HandInFile[] = [];
  // One after the other: 500 runs do not fit into memory at the same time.
  for (const file of files) read.push({ name: file.name, read: await readFile(file) });
  return read;
}

async function readFile(file: TextFile): Promise<ReadHandIn> {
  if (file.size > MAX_FILE_BYTES) {
    return refuse("file-size", `found ${file.size} bytes, expected at most ${MAX_FILE_BYTES}`);
  }
  let text: string;
  try {
    text = await file.text();
  } catch {
    // A folder, or a file that was moved or locked in the meantime.
    return refuse("file-unreadable", "found no text, expected a readable file");
  }
  return readHandInFile(text);
}

function refuse(code: HandInProblem["code"], problem: string): ReadHandIn {
  return { ok: false, code, problems: [], problem };
}

/** Number of hand-ins, without reading them. */
export function countHandIns(files: readonly HandInFile[], text: string): number {
  return files.length + text.split("\n").filter((line) => line.trim() !== "").length;
}

/**
 * The files, then the lines of the text.
 * @param text at most `MAX_HAND_INS` lines
 * @param lesson the lesson that completion codes must belong to
 */
export function entriesOf(
  files: readonly HandInFile[],
  text: string,
  lesson: LessonDocument,
): HandInEntry[] {
  const fromFiles = files.map(({ name, read }) => ({ source: { file: name }, read }));
  const lines = handInsOf(text, lesson);
  if (!lines.ok) return fromFiles;
  return [...fromFiles, ...lines.value.map(({ line, read }) => ({ source: { line }, read }))];
}

/**
 * Two attempts with the same text drive the robot in the same way. The name of a program does not
 * count.
 */
export function attemptText(attempt: Attempt): string {
  return JSON.stringify(isProgram(attempt) ? [attempt.default, attempt.rules] : attempt);
}

/** A task of the lesson that is checked. */
export interface ChosenTask {
  /** from 1 */
  number: number;
  task: LessonTask;
}
