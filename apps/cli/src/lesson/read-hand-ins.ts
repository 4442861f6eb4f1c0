/**
 * Reads the hand-ins of a class: files of programs and runs, and a file with one link or completion
 * code on each line.
 */
import type { LessonDocument } from "@corridor/challenge";
import { handInsOf, readHandInFile, type HandIn, type HandInLine } from "@corridor/link";
import { describeProblem, type ReadResult } from "@corridor/protocol";
import { InputError } from "../input-error.ts";
import { MAX_BYTES, readFile } from "../read-files.ts";
import { readUtf8 } from "../read-utf8.ts";

/** Reads files of programs and runs. @throws InputError with every problem of every file */
export function readHandInFiles(files: readonly string[]): { name: string; value: HandIn }[] {
  const problems: string[] = [];
  const handIns = files.flatMap((name) => {
    const read = readFile(name, readAttempt);
    if (read.ok) return [{ name, value: read.value }];
    problems.push(...read.problems.map((each) => `${name}: ${describeProblem(each)}`));
    return [];
  });
  if (problems.length > 0) throw new InputError(problems);
  return handIns;
}

function readAttempt(text: string): ReadResult<HandIn> {
  const read = readHandInFile(text);
  return read.ok ? read : { ok: false, problems: [...read.problems] };
}

/**
 * Reads a file, or standard input for "-".
 * @throws InputError if it cannot be read as a whole
 */
export async function readHandIns(file: string, lesson: LessonDocument): Promise<HandInLine[]> {
  const readLines = (text: string) => handInsOf(text, lesson);
  const read =
    file === "-" ? readUtf8(await readStandardInput(), readLines) : readFile(file, readLines);
  if (read.ok) return read.value;
  const name = file === "-" ? "standard input" : file;
  throw new InputError(read.problems.map((each) => `${name}: ${describeProblem(each)}`));
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
