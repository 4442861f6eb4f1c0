/** Decodes the link in the page's address. So far, the page opens lessons that version 1 can hold. */
import { oldestDocumentOf, type ChallengeDocument } from "@corridor/challenge";
import { decodeLink, type LinkContent, type LinkRefusal } from "@corridor/link";

export interface SharedContent extends Pick<LinkContent, "maze" | "program" | "run"> {
  challenge?: ChallengeDocument;
}

export type SharedLinkResult =
  | { ok: true; value: SharedContent }
  | { ok: false; code: LinkRefusal };

/** @param text the text after # */
export function decodeSharedLink(text: string): SharedLinkResult {
  const link = decodeLink(text);
  if (!link.ok) return { ok: false, code: link.code };
  const { lesson, completion, ...content } = link.value;
  if (completion !== undefined) return { ok: false, code: "unknown-version" };
  if (lesson === undefined) return { ok: true, value: content };
  const document = oldestDocumentOf(lesson);
  return document.version === 1
    ? { ok: true, value: { ...content, challenge: document } }
    : { ok: false, code: "unknown-version" };
}
