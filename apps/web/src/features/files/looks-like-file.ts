/** Distinguishes text that is meant as a file from text that was pasted by accident. */
import { isContestText } from "@corridor/maze";

const DRAWN = /[#█._|\-+^><▲►▼◄]/g;
/** A drawing whose blocks are letters. A word of these letters is shorter. */
const DRAWN_IN_LETTERS = /^[XxSG.#█^>v<]{9,}$/;
const BLOCK_LETTERS = /[Xx]/g;

/**
 * Whether a text starts like a document, or at least half of its visible characters draw a maze.
 * Problems of such a text are worth reporting.
 */
export function looksLikeFile(text: string): boolean {
  const seen = text.replaceAll(/\s|\uFEFF/g, "");
  return seen.startsWith("{") || isDrawn(seen) || isContestText(text);
}

/** A condition in words of any language: "right > 60". */
const COMPARED = /\p{Letter}{2,}\s*[<>]\s*\d/u;

/**
 * Whether a text that does not start like a document is meant as a program, not as a drawn maze.
 */
export function looksLikeProgram(text: string): boolean {
  if (isDrawn(text.replaceAll(/\s/g, ""))) return false;
  return /corridor\/program|"rules"/.test(text) || COMPARED.test(text);
}

function isDrawn(seen: string): boolean {
  const isMostly = (marks: RegExp) => (seen.match(marks)?.length ?? 0) * 2 >= seen.length;
  return (
    seen !== "" && (isMostly(DRAWN) || (DRAWN_IN_LETTERS.test(seen) && isMostly(BLOCK_LETTERS)))
  );
}
