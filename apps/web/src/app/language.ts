/**
 * The language of the page: the one in the address (`?lang=de`, for sharing), else the one that was
 * chosen on this device, else the first of the browser's that there is, else English.
 */
import type { i18n } from "i18next";
import { showLanguage, shownLanguage } from "../text/i18n.ts";
import { languageOf, languages, matchLanguage, type LanguageTag } from "../text/languages.ts";
import { showMessage, type ScreenStore } from "../stores/screen-store.ts";
import type { KeyValueStorage } from "./works.ts";

const LANGUAGE_KEY = "corridor.language";
const PARAMETER = "lang";

export interface LanguagePorts {
  words: i18n;
  screen: ScreenStore;
  storage: KeyValueStorage;
  /** the languages that are complete */
  offered: readonly LanguageTag[];
  /** navigator.languages, the dearest first */
  preferred: readonly string[];
  location: Pick<Location, "pathname" | "search" | "hash">;
  /** replaces the address without a reload: history.replaceState */
  replaceAddress: (address: string) => void;
  /** shows it outside of React: `lang`, `dir` and the title of the document */
  apply: (shown: { tag: LanguageTag; dir: "ltr" | "rtl"; title: string }) => void;
}

export class LanguageChoice {
  readonly #ports: LanguagePorts;
  /** the newest wish; one that comes later than another is not overtaken by it */
  #wished: LanguageTag;

  constructor(ports: LanguagePorts) {
    this.#ports = ports;
    this.#wished = shownLanguage(ports.words);
    ports.words.on("languageChanged", () => this.#apply());
  }

  /** Shows what the address, the device or the browser asks for. Never fails: English is there. */
  async start(): Promise<void> {
    const { storage, offered, preferred, location, screen, words } = this.#ports;
    const asked = new URLSearchParams(location.search).get(PARAMETER);
    const all = languages.map(({ tag }) => tag);
    const inAddress = asked === null ? null : matchLanguage([asked], all);
    const kept = offered.find((tag) => tag === storage.getItem(LANGUAGE_KEY));
    await this.#show(inAddress ?? kept ?? matchLanguage(preferred, offered) ?? "en");
    this.#apply();
    if (asked !== null && inAddress === null) {
      this.#writeAddress(null);
      showMessage(screen, { tone: "info", text: words.t("language.unknown", { tag: asked }) });
    }
  }

  /** The reader's own choice: kept on the device, and in the address, so that copying it shares it. */
  async choose(tag: LanguageTag): Promise<void> {
    if (!(await this.#show(tag))) return;
    this.#writeAddress(tag);
    try {
      this.#ports.storage.setItem(LANGUAGE_KEY, tag);
    } catch {
      // The choice then lasts until the page is left.
    }
  }

  /** @returns whether it is shown now; if not, the reader was told why, or has chosen another since */
  async #show(tag: LanguageTag): Promise<boolean> {
    const { words, screen } = this.#ports;
    this.#wished = tag;
    try {
      await showLanguage(words, tag, () => this.#wished === tag);
    } catch {
      this.#wished = shownLanguage(words);
      const language = languageOf(tag).name;
      showMessage(screen, { tone: "bad", text: words.t("language.notLoaded", { language }) });
    }
    return shownLanguage(words) === tag;
  }

  #apply(): void {
    const { words, apply } = this.#ports;
    const { tag, dir } = languageOf(shownLanguage(words));
    apply({ tag, dir, title: words.t("language.pageTitle") });
  }

  #writeAddress(tag: LanguageTag | null): void {
    const { location, replaceAddress } = this.#ports;
    const parameters = new URLSearchParams(location.search);
    if (tag === null) parameters.delete(PARAMETER);
    else parameters.set(PARAMETER, tag);
    const search = parameters.size === 0 ? "" : `?${parameters}`;
    replaceAddress(location.pathname + search + location.hash);
  }
}

/**
 * What a shared link says of the language: nothing unless this page's own address does.
 * @param search of the page's address
 * @returns "?lang=de" or ""
 */
export function sharedSearch(search: string): string {
  const tag = new URLSearchParams(search).get(PARAMETER);
  return tag === null ? "" : `?${new URLSearchParams({ [PARAMETER]: tag })}`;
}
