/** What a text is that somebody pastes into the page. Loaded with the first one. */
import { looksLikeFile } from "./looks-like-file.ts";

/** @returns the address of one of our own links, or whether the text is meant to be opened as a file */
export function readPasted(text: string, origin: string): "file" | "other" | URL {
  return ownLink(text, origin) ?? (looksLikeFile(text) ? "file" : "other");
}

/**
 * @param origin where this page comes from: links of other places are not ours
 * @returns null for a text that is no link, and for the page's own plain address
 */
function ownLink(text: string, origin: string): URL | null {
  const trimmed = text.trim();
  if (/\s/.test(trimmed) || !URL.canParse(trimmed)) return null;
  const url = new URL(trimmed);
  const leadsSomewhere = url.pathname !== "/" || url.hash.length > 1;
  return url.origin === origin && leadsSomewhere ? url : null;
}
