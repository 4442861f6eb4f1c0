/** What a saved document is called on the reader's disk. */

/** Characters of a name that are kept: every file system takes so many, with any ending. */
const MAX_LENGTH = 60;

/**
 * Letters and digits of any script; everything else would trouble one file system or another.
 * @param name any text
 * @param fallback used where nothing of the name is left
 */
export function fileName(name: string, fallback: string): string {
  const clean = name
    .toLowerCase()
    .replaceAll(/[^\p{Letter}\p{Mark}\p{Number}]+/gu, "-")
    .replaceAll(/^-|-$/g, "");
  const short = Array.from(clean).slice(0, MAX_LENGTH).join("").replace(/-$/, "");
  return short === "" ? fallback : short;
}
