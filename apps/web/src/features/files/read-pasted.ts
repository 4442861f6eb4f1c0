/** Classifies text that the user pastes into the page. This module is a separate chunk. */
import { keyPrefixes } from "@corridor/protocol";
import { looksLikeFile } from "./looks-like-file.ts";

/** Paths of links: the page with a fragment, short links, and addresses of robots. */
const LINK_PATH = /^\/(?:[mr]\/[^/]+\/?)?$/;

/**
 * Classifies a text.
 * - a URL: one of our own links
 * - "script": the address of a robot with a script's key
 * - "file": text that is meant as a file
 * - "other": any other text
 */
export function readPasted(text: string, origin: string): "file" | "script" | "other" | URL {
  const link = ownLink(text, origin);
  // The link would replace the page and its robot by a page that displays no more than this
  // message.
  if (link !== null && link.hash.startsWith(`#${keyPrefixes.drive}`)) return "script";
  return link ?? (looksLikeFile(text) ? "file" : "other");
}

/**
 * @param origin origin of this page; links to other origins do not count
 * @returns null for a text that is no link, and for the plain address of the page
 */
function ownLink(text: string, origin: string): URL | null {
  const { host, protocol } = new URL(origin);
  const trimmed = text.trim();
  // On a board, and where Remote displays it, an address starts with the host.
  const whole = trimmed.startsWith(`${host}/`) ? `${protocol}//${trimmed}` : trimmed;
  if (/\s/.test(whole) || !URL.canParse(whole)) return null;
  const url = new URL(whole);
  const leadsSomewhere = url.pathname !== "/" || url.hash.length > 1;
  return url.origin === origin && leadsSomewhere && LINK_PATH.test(url.pathname) ? url : null;
}
