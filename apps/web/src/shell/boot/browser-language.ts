/** Language choice with the dependencies of a real browser: address, languages, document. */
import type { i18n } from "i18next";
import type { ScreenStore } from "../../model/screen/screen-store.ts";
import { offeredLanguages } from "../../text/languages.ts";
import { LanguageChoice } from "../../model/preferences/language.ts";
import type { KeyValueStorage } from "../../model/storage/key-value-storage.ts";

export function browserLanguage(
  words: i18n,
  screen: ScreenStore,
  storage: KeyValueStorage,
): LanguageChoice {
  return new LanguageChoice({
    words,
    screen,
    storage,
    offered: offeredLanguages.map(({ tag }) => tag),
    preferred: navigator.languages,
    location,
    replaceAddress: (address) => history.replaceState(history.state, "", address),
    apply: ({ tag, dir, title }) => {
      Object.assign(document.documentElement, { lang: tag, dir });
      document.title = title;
    },
  });
}
