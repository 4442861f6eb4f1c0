/**
 * All texts on the screen come from a catalogue: `t("stage.clear")`. The compiler checks the keys.
 * English is part of the page (`english-words.ts`); `load-words.ts` loads the other languages.
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

/** Returns an instance that is ready, in English. React escapes texts itself. */
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

/** The displayed language. */
export function shownLanguage({ language }: Pick<i18n, "language">): LanguageTag {
  return language as LanguageTag;
}

/**
 * Displays another language. Loads all namespaces in use first, then changes them together.
 * @param isWanted called after loading; false if the user has chosen another language meanwhile
 * @throws if texts cannot be fetched; the language then stays the same
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
 * A value inside a sentence, with the number format of the language. In a right-to-left language,
 * the value is wrapped in a first strong isolate (U+2068).
 */
function written(value: string, tag: LanguageTag): string {
  // A number with three digits after the point is grouped: "1.001" in German.
  const text = /^-?\d+\.\d{1,2}$/.test(value) ? localNumber(value, tag) : value;
  return languageOf(tag).dir === "rtl" ? `\u2068${text}\u2069` : text;
}
