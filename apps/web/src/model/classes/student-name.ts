/**
 * The name of a student as text. The relay assigns the number of a word, so the keys of `names.json`
 * are part of the format: a word may be replaced, but it never gets another key.
 */
import type { StudentName } from "@corridor/protocol";
import type { TFunction } from "i18next";

/**
 * @param t of the namespace "names", which must be loaded
 * @returns the pseudonym from the teacher, or the word in the language of the page
 */
export function studentNameText(t: TFunction<"names">, { text, word }: StudentName): string {
  return text ?? Object.values(t("words", { returnObjects: true }))[word ?? 0] ?? "";
}
