/** The documents of a shared lesson, and the limits that it exceeds. */
import {
  MAX_CHALLENGE_TEXT_LENGTH,
  oldestDocumentOf,
  type ChallengeDocument,
  type LessonDocument,
} from "@corridor/challenge";
import { encodeLink, MAX_LINK_LENGTH, type LessonPart } from "@corridor/link";
import { MAX_DOCUMENT_BYTES } from "@corridor/protocol";

/** By how much a lesson exceeds a limit. */
export interface Excess {
  /** in characters for a link or a file, in bytes for a short link */
  size: number;
  limit: number;
  /** the part to shorten */
  longest: LessonPart;
}

export interface ShareSizes {
  /** for a file or a short link */
  document: ChallengeDocument | LessonDocument;
  /** the text after `#`; null if the lesson is too large for a link */
  link: string | null;
  /** A lesson beyond the bounds of a link apart from its length is too large for a file, too. */
  excesses: { link?: Excess; shortLink?: Excess; file?: Excess };
}

/** @param lesson a valid lesson */
export function shareSizesOf(lesson: LessonDocument): ShareSizes {
  const document = oldestDocumentOf(lesson);
  const longest = largestPartOf(lesson);
  const excesses: ShareSizes["excesses"] = {};
  const link = encodeLink({ lesson });
  if (!link.ok && link.length !== null) {
    const { length: size } = link;
    excesses.link = { size, limit: MAX_LINK_LENGTH, longest: link.longest ?? longest };
  }
  const stored = new TextEncoder().encode(JSON.stringify(document)).length;
  if (stored > MAX_DOCUMENT_BYTES) {
    excesses.shortLink = { size: stored, limit: MAX_DOCUMENT_BYTES, longest };
  }
  // A file is indented, and ends with a line break.
  const file = JSON.stringify(document, null, 2).length + 1;
  if (file > MAX_CHALLENGE_TEXT_LENGTH) {
    excesses.file = { size: file, limit: MAX_CHALLENGE_TEXT_LENGTH, longest };
  }
  return { document, link: link.ok ? link.text : null, excesses };
}

/** The part that takes the most characters in a document. */
function largestPartOf({ name, intro, survey, tasks }: LessonDocument): LessonPart {
  const parts: (LessonPart & { length: number })[] = tasks.flatMap((each, task) => [
    { task, part: "texts", length: lengthOf([each.name, each.words]) },
    { task, part: "mazes", length: lengthOf(each.mazes) },
    { task, part: "program", length: lengthOf(each.program) },
  ]);
  const { task, part } = parts.reduce((most, each) => (each.length > most.length ? each : most), {
    task: null,
    part: "texts",
    length: lengthOf([name, intro, survey]),
  });
  return { task, part };
}

function lengthOf(content: unknown): number {
  return JSON.stringify(content).length;
}
