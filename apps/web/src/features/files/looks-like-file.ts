/** Tells a text that is meant to be opened from one that was pasted by a slip. */

const DRAWN = /[#._|\-+^><▲►▼◄]/g;

/**
 * Whether a text begins as a document does, or at least half of what is to be seen of it draws a maze:
 * then what is wrong with it is worth telling.
 */
export function looksLikeFile(text: string): boolean {
  const seen = text.replaceAll(/\s|\uFEFF/g, "");
  if (seen.startsWith("{")) return true;
  return seen !== "" && (seen.match(DRAWN)?.length ?? 0) * 2 >= seen.length;
}
