/** Reads the lesson that a teacher opens: a link, a short link, or the text of its document. */
import { readLesson, type LessonDocument } from "@corridor/challenge";
import { readLessonLink, type AddressRefusal } from "@corridor/link";
import type { FieldProblem } from "@corridor/protocol";
import type { ShortLinkResult } from "../../../model/address/short-link.ts";
import type { TextFile } from "../../../ui/incoming-files.ts";

/** The longest run fits. */
export const MAX_FILE_BYTES = 9_000_000;

/** Why no lesson was opened. */
export interface LessonProblem {
  code:
    | AddressRefusal
    | "no-lesson"
    /** a file or a text that is not a lesson */
    | "document"
    | "file-size"
    | "file-unreadable"
    /** a short link whose document was deleted, or that never existed */
    | "gone"
    /** too many wrong short links came from this network */
    | "wait"
    /** the service did not respond */
    | "offline";
  problems: readonly FieldProblem[];
}

export type OpenedLesson = { ok: true; lesson: LessonDocument } | ({ ok: false } & LessonProblem);

/** @param text JSON of a lesson @returns the lesson, or its problems */
export function readLessonText(text: string): OpenedLesson {
  const read = readLesson(text.replace(/^\uFEFF/, ""));
  return read.ok ? { ok: true, lesson: read.value } : { ...read, code: "document" };
}

/** Whether a text is meant as a lesson, readable or not. */
export function looksLikeLesson(text: string): boolean {
  return /"format"\s*:\s*"corridor\/challenge"/.test(text);
}

/** Reads a file that must contain a lesson. */
export async function readLessonFile(file: TextFile): Promise<OpenedLesson> {
  if (file.size > MAX_FILE_BYTES) return refuse("file-size");
  try {
    return readLessonText(await file.text());
  } catch {
    return refuse("file-unreadable");
  }
}

/**
 * Reads a pasted text: a link, a short link of this service, or a document.
 * @param host host of this page
 * @param readShortLink requests the document of a short link from the service
 */
export async function readLessonAddress(
  text: string,
  host: string,
  readShortLink: (id: string) => Promise<ShortLinkResult>,
): Promise<OpenedLesson> {
  const address = text.trim();
  if (address.startsWith("{")) return readLessonText(address);
  const [, where, id] = /^(?:https?:\/\/)?([^/]+)\/m\/([^/#?]+)\/?$/.exec(address) ?? [];
  if (id === undefined || where !== host) {
    const read = readLessonLink(address);
    return read.ok ? { ok: true, lesson: read.value } : read;
  }
  try {
    return lessonOfShortLink(await readShortLink(id));
  } catch {
    return refuse("offline");
  }
}

function lessonOfShortLink(read: ShortLinkResult): OpenedLesson {
  if (read.ok) {
    const { lesson } = read.value;
    return lesson === undefined ? refuse("no-lesson") : { ok: true, lesson };
  }
  switch (read.sentence) {
    case "share.shortLink.gone":
      return refuse("gone");
    case "share.shortLink.wait":
      return refuse("wait");
    case "share.linkProblems.unknown-version":
      return refuse("unknown-version");
  }
}

function refuse(code: LessonProblem["code"]): OpenedLesson {
  return { ok: false, code, problems: [] };
}
