/** Reads the hand-ins of a class: one link of a program on each line. */
import type { ProgramDocument } from "@corridor/program";
import { describeProblem, problem, type ReadResult } from "@corridor/protocol";
import { InputError } from "../input-error.ts";
import { MAX_BYTES, readBytes, readFile } from "../read-files.ts";
import { readLinkPart } from "./read-link.ts";

/** Maximum number of hand-ins. */
const MAX_HAND_INS = 10_000;

export interface HandIn {
  /** such as "line 3" */
  name: string;
  /** the program, or why the line is not a link of a program */
  read: ReadResult<ProgramDocument>;
}

/** Reads a file, or standard input for "-". @throws InputError if it cannot be read as a whole */
export async function readHandIns(file: string): Promise<HandIn[]> {
  const read =
    file === "-" ? readBytes(await readStandardInput(), handInsOf) : readFile(file, handInsOf);
  if (read.ok) return read.value;
  const name = file === "-" ? "standard input" : file;
  throw new InputError(read.problems.map((each) => `${name}: ${describeProblem(each)}`));
}

/** Returns the hand-ins of a text. Ignores blank lines. */
export function handInsOf(text: string): ReadResult<HandIn[]> {
  const lines = text
    .split("\n")
    .map((line, at) => ({ name: `line ${at + 1}`, link: line.trim() }))
    .filter(({ link }) => link !== "");
  if (lines.length > MAX_HAND_INS) {
    return problem("", `${lines.length} lines`, `at most ${MAX_HAND_INS} lines`);
  }
  const handIns = lines.map(({ name, link }) => ({ name, read: readLinkPart(link, "program") }));
  return { ok: true, value: handIns };
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
