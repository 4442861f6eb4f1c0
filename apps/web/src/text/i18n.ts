/**
 * Every word on the screen comes from a catalogue: `t("stage.clear")`, with keys that the compiler
 * checks. English comes with the page (`english-words.ts`), other languages by `load-words.ts`.
 */
import i18next, { type i18n } from "i18next";
import { initReactI18next } from "react-i18next";
import type { en } from "./en/index.ts";
import { languageOf, type LanguageTag } from "./languages.ts";
import { loadWords, wordsBackend } from "./load-words.ts";
import type { Namespace, Namespaces } from "./namespaces.ts";
import { localNumber } from "./numbers.ts";

declare module "i18next" {
  interface CustomTypeOptions {
    defaultNS: "words";
    resources: Namespaces;
  }
}

/** Ready at once, in English. React escapes text itself. */
export function createI18n(english: typeof en): i18n {
  const instance = i18next.createInstance();
  void instance
    .use(initReactI18next)
    .use(wordsBackend)
    .init({
      lng: "en",
      fallbackLng: "en",
      load: "currentOnly",
      defaultNS: "words",
      ns: ["words"],
      resources: { en: { words: english } },
      partialBundledLanguages: true,
      interpolation: {
        escapeValue: true,
        escape: (value: string) => written(value, shownLanguage(instance)),
      },
      initAsync: false,
      returnNull: false,
    });
  return instance;
}

/** The language that is shown. */
export function shownLanguage({ language }: Pick<i18n, "language">): LanguageTag {
  return language as LanguageTag;
}

/**
 * Shows another language: first everything that is in use is fetched, then all of it changes at once.
 * @param isWanted asked when all is there; a later choice may have come in between
 * @throws when words cannot be fetched; the language is then the one from before
 */
export async function showLanguage(
  words: i18n,
  tag: LanguageTag,
  isWanted: () => boolean = () => true,
): Promise<void> {
  const inUse = usedNamespaces(words).filter((each) => !words.hasResourceBundle(tag, each));
  const fetched = await Promise.all(inUse.map((namespace) => loadWords(tag, namespace)));
  inUse.forEach((namespace, at) => words.addResourceBundle(tag, namespace, fetched[at]));
  if (isWanted()) await words.changeLanguage(languageOf(tag).tag);
}

function usedNamespaces(words: i18n): Namespace[] {
  const known = words.options.ns ?? [];
  const all = (Array.isArray(known) ? known : [known]) as Namespace[];
  return all.filter((each) => words.hasResourceBundle(words.language, each));
}

/**
 * A value inside a sentence: a number as the language writes it, and, where the sentence runs the other
 * way, set apart by "first strong isolate" and its end.
 */
function written(value: string, tag: LanguageTag): string {
  const text = /^-?\d+\.\d+$/.test(value) ? localNumber(value, tag) : value;
  return languageOf(tag).dir === "rtl" ? `\u2068${text}\u2069` : text;
}
