/** Reads the lesson of `grade --challenge` from a file or a link. */
import { existsSync } from "node:fs";
import { readLesson, type LessonDocument } from "@corridor/challenge";
import { readLessonLink } from "@corridor/link";
import { describeProblem } from "@corridor/protocol";
import { InputError } from "../input-error.ts";
import { readFile } from "../read-files.ts";

/** An address, or the text of a link after `#`: its version, then letters, digits, - and _. */
const LINK = /#|^https?:\/\/|^\d[\w-]{6,}$/;

/** @param source path of a file, or a link @throws InputError if it contains no lesson */
export function readLessonFrom(source: string): LessonDocument {
  const isLink = !existsSync(source) && LINK.test(source);
  const read = isLink ? readLessonLink(source) : readFile(source, readLesson);
  if (read.ok) return read.value;
  // A link is too long to repeat.
  const name = isLink ? "--challenge" : source;
  throw new InputError(read.problems.map((each) => `${name}: ${describeProblem(each)}`));
}
