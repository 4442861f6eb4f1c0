/**
 * The name of a student as text. The relay assigns the number of a word, so the keys of `names.json`
 * are part of the format: a word may be replaced, but it never gets another key.
 */
import type { StudentName } from "@corridor/protocol";
import type { TFunction } from "i18next";

/** the words of each language; reading them is too slow for every render of every card */
const known = new WeakMap<TFunction<"names">, readonly string[]>();

/**
 * @param t of the namespace "names", which must be loaded
 * @returns the pseudonym from the teacher, or the word in the language of the page
 */
export function studentNameText(t: TFunction<"names">, { text, word }: StudentName): string {
  if (text !== null) return text;
  const words = known.get(t) ?? Object.values(t("words", { returnObjects: true }));
  known.set(t, words);
  return words[word ?? 0] ?? "";
}
