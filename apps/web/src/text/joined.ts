/**
 * Texts side by side, joined as the language joins them: "row 3, column 7" is 「3段目、7列目」 in Japanese,
 * and its sentences stand without spaces. Only for parts that are whole by themselves: what bends with
 * its neighbours is one sentence of the catalogue.
 */
import type { TFunction } from "i18next";

/** The parts were written by the catalogue already: nothing in them is set apart or changed again. */
const interpolation = { escapeValue: false };

/** "row 3, column 7, open" */
export function joinList(t: TFunction, parts: readonly string[]): string {
  return joined(t, "list", parts);
}

/** Sentences after one another, each with its full stop. */
export function joinSentences(t: TFunction, sentences: readonly string[]): string {
  return joined(t, "sentences", sentences);
}

/** A text without a full stop as a sentence of its own. */
export function asSentence(t: TFunction, text: string): string {
  return t("language.join.sentence", { text, interpolation });
}

function joined(t: TFunction, how: "list" | "sentences", [first = "", ...rest]: readonly string[]) {
  return rest.reduce(
    (one, other): string => t(`language.join.${how}`, { one, other, interpolation }),
    first,
  );
}
