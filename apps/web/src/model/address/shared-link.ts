/** Decodes the link in the page's address. The page has no use for a completion code. */
import { decodeLink, type LinkContent, type LinkRefusal } from "@corridor/link";

export type SharedContent = Omit<LinkContent, "completion">;

export type SharedLinkResult =
  | { ok: true; value: SharedContent }
  | { ok: false; code: LinkRefusal };

/** @param text the text after # */
export function decodeSharedLink(text: string): SharedLinkResult {
  const link = decodeLink(text);
  if (!link.ok) return { ok: false, code: link.code };
  const { completion, ...content } = link.value;
  return completion === undefined
    ? { ok: true, value: content }
    : { ok: false, code: "unknown-version" };
}
