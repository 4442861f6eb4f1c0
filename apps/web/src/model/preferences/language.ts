/**
 * The language of the page: the one in the address (`?lang=de`, for sharing), or the one stored on
 * this device, or the first available one of the browser's, or English.
 */
import type { i18n } from "i18next";
import { showLanguage, shownLanguage } from "../../text/i18n.ts";
import { languageOf, languages, matchLanguage, type LanguageTag } from "../../text/languages.ts";
import { showMessage, type ScreenStore } from "../screen/screen-store.ts";
import type { KeyValueStorage } from "../storage/key-value-storage.ts";

const LANGUAGE_KEY = "corridor.language";
const PARAMETER = "lang";

export interface LanguagePorts {
  words: i18n;
  screen: ScreenStore;
  storage: KeyValueStorage;
  /** languages with complete texts */
  offered: readonly LanguageTag[];
  /** navigator.languages, most preferred first */
  preferred: readonly string[];
  location: Pick<Location, "pathname" | "search" | "hash">;
  /** replaces the address without a reload: history.replaceState */
  replaceAddress: (address: string) => void;
  /** applies it outside of React: `lang`, `dir` and the title of the document */
  apply: (shown: { tag: LanguageTag; dir: "ltr" | "rtl"; title: string }) => void;
}

export class LanguageChoice {
  readonly #ports: LanguagePorts;
  /** the newest requested language; an earlier request that loads later does not replace it */
  #requested: LanguageTag;

  constructor(ports: LanguagePorts) {
    this.#ports = ports;
    this.#requested = shownLanguage(ports.words);
    ports.words.on("languageChanged", () => this.#apply());
  }

  /**
   * Displays the language of the address, the device or the browser. Never fails: English is
   * bundled.
   */
  async start(): Promise<void> {
    const { storage, offered, preferred, location, screen, words } = this.#ports;
    const asked = new URLSearchParams(location.search).get(PARAMETER);
    const all = languages.map(({ tag }) => tag);
    const inAddress = asked === null ? null : matchLanguage([asked], all);
    const stored = offered.find((tag) => tag === storage.getItem(LANGUAGE_KEY));
    await this.#show(inAddress ?? stored ?? matchLanguage(preferred, offered) ?? "en");
    this.#apply();
    if (asked !== null && inAddress === null) {
      this.#writeAddress(null);
      showMessage(screen, { tone: "info", text: words.t("language.unknown", { tag: asked }) });
    }
  }

  /**
   * The user's own choice: stored on the device, and in the address, so that copying the address
   * shares it.
   */
  async choose(tag: LanguageTag): Promise<void> {
    if (!(await this.#show(tag))) return;
    this.#writeAddress(tag);
    try {
      this.#ports.storage.setItem(LANGUAGE_KEY, tag);
    } catch {
      // The choice then lasts until the page is left.
    }
  }

  /**
   * @returns whether it is displayed now; if not, a message says why, or the user has chosen
   *   another one
   */
  async #show(tag: LanguageTag): Promise<boolean> {
    const { words, screen } = this.#ports;
    this.#requested = tag;
    try {
      await showLanguage(words, tag, () => this.#requested === tag);
    } catch {
      this.#requested = shownLanguage(words);
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
 * Search part of a shared link: the language parameter of this page's own address, if any.
 * @param search search part of the page's address
 * @returns "?lang=de" or ""
 */
export function sharedSearch(search: string): string {
  const tag = new URLSearchParams(search).get(PARAMETER);
  return tag === null ? "" : `?${new URLSearchParams({ [PARAMETER]: tag })}`;
}
