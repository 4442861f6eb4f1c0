/**
 * Joins texts with the separators of the language: "row 3, column 7" is 「3段目、7列目」 in Japanese, which
 * has no spaces between sentences. Only for independent parts: words that inflect together are one
 * sentence of the catalogue.
 */
import type { TFunction } from "i18next";

/** The catalogue has already escaped and isolated the parts. */
const interpolation = { escapeValue: false };

/** "row 3, column 7, open" */
export function joinList(t: TFunction, parts: readonly string[]): string {
  return joined(t, "list", parts);
}

/** Joins sentences that end with their full stops. */
export function joinSentences(t: TFunction, sentences: readonly string[]): string {
  return joined(t, "sentences", sentences);
}

/** Adds the full stop to a text. */
export function asSentence(t: TFunction, text: string): string {
  return t("language.join.sentence", { text, interpolation });
}

function joined(t: TFunction, how: "list" | "sentences", [first = "", ...rest]: readonly string[]) {
  return rest.reduce(
    (one, other): string => t(`language.join.${how}`, { one, other, interpolation }),
    first,
  );
}
