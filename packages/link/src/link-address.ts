/** Reads shared links, as complete addresses or as text. A link contains its documents. */
import type { LessonDocument } from "@corridor/challenge";
import type { FieldProblem } from "@corridor/protocol";
import type { LinkContent } from "./link-body.ts";
import { decodeLink, type LinkRefusal } from "./link.ts";

/** Reason why an address cannot be decoded. */
export type AddressRefusal =
  | LinkRefusal
  /** a short link, whose document only a service has */
  | "short-link";

export type AddressResult =
  | { ok: true; value: LinkContent }
  | { ok: false; code: AddressRefusal; problems: FieldProblem[] };

/**
 * Returns the content of a link.
 * @param text complete address with `#`, or the text after `#`
 */
export function readLink(text: string): AddressResult {
  const hash = text.indexOf("#");
  if (hash < 0 && text.includes("/")) {
    const problem = {
      path: "link",
      found: "an address without #",
      expected: "the complete link, with the text after #: a short link is not fetched",
    };
    return { ok: false, code: "short-link", problems: [problem] };
  }
  return decodeLink(text.slice(hash + 1));
}

export type LessonLinkResult =
  | { ok: true; value: LessonDocument }
  | {
      ok: false;
      /** `no-lesson`: a link of something else */
      code: AddressRefusal | "no-lesson";
      problems: FieldProblem[];
    };

/** Returns the lesson of a link. @param text see `readLink` */
export function readLessonLink(text: string): LessonLinkResult {
  const read = readLink(text);
  if (!read.ok) return read;
  const { lesson } = read.value;
  if (lesson !== undefined) return { ok: true, value: lesson };
  const problem = {
    path: "link",
    found: "a link without a lesson",
    expected: "a link with a lesson",
  };
  return { ok: false, code: "no-lesson", problems: [problem] };
}
