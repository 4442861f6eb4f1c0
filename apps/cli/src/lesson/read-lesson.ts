/** Reads the lesson of `grade --challenge` from a file or a link. */
import { existsSync } from "node:fs";
import { readLesson, type LessonDocument } from "@corridor/challenge";
import { describeProblem, problem, type ReadResult } from "@corridor/protocol";
import { InputError } from "../input-error.ts";
import { readFile } from "../read-files.ts";
import { readLink } from "./read-link.ts";

/** The text of a link after `#`: its version, then letters, digits, - and _. */
const LINK_TEXT = /^\d[\w-]{6,}$/;

/** @param source path of a file, or a link @throws InputError if it contains no lesson */
export function readLessonFrom(source: string): LessonDocument {
  const isLink = !existsSync(source) && (source.includes("#") || LINK_TEXT.test(source));
  const read = isLink ? lessonOfLink(source) : readFile(source, readLesson);
  if (read.ok) return read.value;
  // A link is too long to repeat.
  const name = isLink ? "--challenge" : source;
  throw new InputError(read.problems.map((each) => `${name}: ${describeProblem(each)}`));
}

function lessonOfLink(link: string): ReadResult<LessonDocument> {
  const read = readLink(link);
  if (!read.ok) return read;
  const { lesson } = read.value;
  return lesson === undefined
    ? problem("link", "a link without a lesson", "a link with a lesson")
    : { ok: true, value: lesson };
}
