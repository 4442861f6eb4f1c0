/** Reads the hand-ins of a class: a link of a program, or a completion code, on each line. */
import { lessonMark, type Attempt, type LessonDocument } from "@corridor/challenge";
import type { CompletionCode } from "@corridor/link";
import { describeProblem, problem, type FieldProblem, type ReadResult } from "@corridor/protocol";
import { InputError } from "../input-error.ts";
import { MAX_BYTES, readBytes, readFile } from "../read-files.ts";
import { readLink } from "./read-link.ts";

/** Maximum number of hand-ins. */
const MAX_HAND_INS = 10_000;

export interface HandIn {
  /** file, or the line such as "line 3" */
  name: string;
  read: ReadHandIn;
}

export type ReadHandIn =
  /** @property task index of the only task to check; null for all tasks */
  | { ok: true; attempt: Attempt; task: number | null }
  /** @property problem why the line is not checked */
  | { ok: false; problem: string };

/**
 * Reads a file, or standard input for "-".
 * @throws InputError if it cannot be read as a whole
 */
export async function readHandIns(file: string, lesson: LessonDocument): Promise<HandIn[]> {
  const readLines = (text: string) => handInsOf(text, lesson);
  const read =
    file === "-" ? readBytes(await readStandardInput(), readLines) : readFile(file, readLines);
  if (read.ok) return read.value;
  const name = file === "-" ? "standard input" : file;
  throw new InputError(describeAll(read.problems).map((each) => `${name}: ${each}`));
}

/** Returns the hand-ins of a text. Ignores blank lines. */
export function handInsOf(text: string, lesson: LessonDocument): ReadResult<HandIn[]> {
  const lines = text
    .split("\n")
    .map((line, at) => ({ name: `line ${at + 1}`, link: line.trim() }))
    .filter(({ link }) => link !== "");
  if (lines.length > MAX_HAND_INS) {
    return problem("", `${lines.length} lines`, `at most ${MAX_HAND_INS} lines`);
  }
  const target = { mark: lessonMark(lesson), tasks: lesson.tasks.length };
  const handIns = lines.map(({ name, link }) => ({ name, read: readHandIn(link, target) }));
  return { ok: true, value: handIns };
}

/** The lesson that codes must belong to. */
interface Target {
  mark: string;
  /** number of tasks */
  tasks: number;
}

function readHandIn(link: string, target: Target): ReadHandIn {
  const read = readLink(link);
  if (!read.ok) return { ok: false, problem: describeAll(read.problems).join("; ") };
  const { completion, program } = read.value;
  if (completion !== undefined) return readCode(completion, target);
  if (program !== undefined) return { ok: true, attempt: program, task: null };
  const missing = problem("link", "a link without a program", "a program or a completion code");
  return { ok: false, problem: describeAll(missing.problems).join("; ") };
}

function readCode({ lesson, task, attempt }: CompletionCode, { mark, tasks }: Target): ReadHandIn {
  if (lesson !== mark) {
    return { ok: false, problem: "Not checked: this code belongs to another lesson" };
  }
  if (task >= tasks) {
    const problem = `Not checked: this code belongs to task ${task + 1}, the lesson has ${tasks}`;
    return { ok: false, problem };
  }
  return { ok: true, attempt, task };
}

function describeAll(problems: readonly FieldProblem[]): string[] {
  return problems.map(describeProblem);
}

async function readStandardInput(): Promise<Buffer> {
  const chunks: Buffer[] = [];
  let bytes = 0;
  for await (const chunk of process.stdin) {
    chunks.push(chunk);
    bytes += chunk.length;
    if (bytes > MAX_BYTES) {
      throw new InputError([`standard input: found more, expected at most ${MAX_BYTES} bytes`]);
    }
  }
  return Buffer.concat(chunks);
}
