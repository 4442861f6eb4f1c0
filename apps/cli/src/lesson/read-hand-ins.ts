/** Reads the hand-ins of a class from a file: one link or completion code on each line. */
import type { LessonDocument } from "@corridor/challenge";
import { handInsOf, type HandInLine } from "@corridor/link";
import { describeProblem } from "@corridor/protocol";
import { InputError } from "../input-error.ts";
import { MAX_BYTES, readFile } from "../read-files.ts";
import { readUtf8 } from "../read-utf8.ts";

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
