/** The file names of saved documents. */

/** Longest name without its ending. Every file system accepts it. */
const MAX_LENGTH = 60;

/**
 * Reduces a name to letters and digits of any script. Other characters are invalid in some file
 * systems.
 * @param name any text
 * @param fallback used if nothing of the name remains
 */
export function fileName(name: string, fallback: string): string {
  const clean = name
    .toLowerCase()
    .replaceAll(/[^\p{Letter}\p{Mark}\p{Number}]+/gu, "-")
    .replaceAll(/^-|-$/g, "");
  const short = Array.from(clean).slice(0, MAX_LENGTH).join("").replace(/-$/, "");
  return short === "" ? fallback : short;
}
