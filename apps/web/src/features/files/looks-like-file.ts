/** Tells a text that is meant to be opened from one that was pasted by a slip. */

const DRAWN = /[#._|\-+^><▲►▼◄]/g;

/**
 * Whether a text begins as a document does, or at least half of what is to be seen of it draws a maze:
 * then what is wrong with it is worth telling.
 */
export function looksLikeFile(text: string): boolean {
  const seen = text.replaceAll(/\s|\uFEFF/g, "");
  return seen.startsWith("{") || isDrawn(seen);
}

/** A condition in words, of whatever language: "right > 60". */
const COMPARED = /\p{Letter}{2,}\s*[<>]\s*\d/u;

/** Whether a text that begins as no document does was meant to be a program, and not a drawn maze. */
export function looksLikeProgram(text: string): boolean {
  if (isDrawn(text.replaceAll(/\s/g, ""))) return false;
  return /corridor\/program|"rules"/.test(text) || COMPARED.test(text);
}

function isDrawn(seen: string): boolean {
  return seen !== "" && (seen.match(DRAWN)?.length ?? 0) * 2 >= seen.length;
}
