/** Tells one of our own links, as somebody pastes it into the page, from any other text. */

/**
 * @param origin where this page comes from: links of other places are not ours
 * @returns null for a text that is no link, and for the page's own plain address
 */
export function ownLink(text: string, origin: string): URL | null {
  const trimmed = text.trim();
  if (/\s/.test(trimmed) || !URL.canParse(trimmed)) return null;
  const url = new URL(trimmed);
  const leadsSomewhere = url.pathname !== "/" || url.hash.length > 1;
  return url.origin === origin && leadsSomewhere ? url : null;
}
