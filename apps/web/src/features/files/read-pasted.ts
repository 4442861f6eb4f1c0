/** What a text is that somebody pastes into the page. Loaded with the first one. */
import { looksLikeFile } from "./looks-like-file.ts";

/** Paths of links: the page with a fragment, short links, and addresses of robots. */
const LINK_PATH = /^\/(?:[mr]\/[^/]+\/?)?$/;

/**
 * @returns the address of one of our own links, "script" for the address of a robot with a script's key, or
 *   whether the text is meant to be opened as a file
 */
export function readPasted(text: string, origin: string): "file" | "script" | "other" | URL {
  const link = ownLink(text, origin);
  // The page would leave its own robot for a page that says no more than this.
  if (link !== null && link.hash.startsWith("#drv_")) return "script";
  return link ?? (looksLikeFile(text) ? "file" : "other");
}

/**
 * @param origin where this page comes from: links of other places are not ours
 * @returns null for a text that is no link, and for the page's own plain address
 */
function ownLink(text: string, origin: string): URL | null {
  const { host, protocol } = new URL(origin);
  const trimmed = text.trim();
  // On a board, and where Remote displays its address, it begins with the host.
  const whole = trimmed.startsWith(`${host}/`) ? `${protocol}//${trimmed}` : trimmed;
  if (/\s/.test(whole) || !URL.canParse(whole)) return null;
  const url = new URL(whole);
  const leadsSomewhere = url.pathname !== "/" || url.hash.length > 1;
  return url.origin === origin && leadsSomewhere && LINK_PATH.test(url.pathname) ? url : null;
}
