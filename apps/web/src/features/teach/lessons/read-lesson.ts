/** Reads the lesson that a teacher opens: a link, a short link, or the text of its document. */
import { readLesson, type LessonDocument } from "@corridor/challenge";
import { readLink, type AddressRefusal, type LinkContent } from "@corridor/link";
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

/** What a pasted text contains. */
export type SharedContent = { ok: true; content: LinkContent } | ({ ok: false } & LessonProblem);

/**
 * Reads a pasted text: a link, a short link of this service, or the document of a lesson.
 * @param host host of this page
 * @param readShortLink requests the document of a short link from the service
 */
export async function readShared(
  text: string,
  host: string,
  readShortLink: (id: string) => Promise<ShortLinkResult>,
): Promise<SharedContent> {
  const address = text.trim();
  if (address.startsWith("{")) {
    const read = readLessonText(address);
    return read.ok ? { ok: true, content: { lesson: read.lesson } } : read;
  }
  const [, where, id] = /^(?:https?:\/\/)?([^/]+)\/m\/([^/#?]+)\/?$/.exec(address) ?? [];
  if (id === undefined || where !== host) {
    const read = readLink(address);
    return read.ok ? { ok: true, content: read.value } : read;
  }
  try {
    return contentOfShortLink(await readShortLink(id));
  } catch {
    return refuse("offline");
  }
}

export function lessonOfShared(read: SharedContent): OpenedLesson {
  if (!read.ok) return read;
  const { lesson } = read.content;
  return lesson === undefined ? refuse("no-lesson") : { ok: true, lesson };
}

function contentOfShortLink(read: ShortLinkResult): SharedContent {
  if (read.ok) return { ok: true, content: read.value };
  switch (read.sentence) {
    case "share.shortLink.gone":
      return refuse("gone");
    case "share.shortLink.wait":
      return refuse("wait");
    case "share.linkProblems.unknown-version":
      return refuse("unknown-version");
  }
}

function refuse(code: LessonProblem["code"]): { ok: false } & LessonProblem {
  return { ok: false, code, problems: [] };
}
