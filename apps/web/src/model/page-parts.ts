/** What a page other than the student's receives from the entry of the page. */
import type { i18n } from "i18next";
import type { ReactNode } from "react";
import type { Root } from "react-dom/client";
import type { ScreenStore } from "./screen/screen-store.ts";
import type { LanguageChoice } from "./preferences/language.ts";
import type { KeyValueStorage } from "./storage/key-value-storage.ts";

export interface PageParts {
  root: Pick<Root, "render">;
  /** in the language of the page */
  words: i18n;
  language: LanguageChoice;
  screen: ScreenStore;
  /** localStorage */
  device: KeyValueStorage;
  /** the buttons for theme and language */
  tools: ReactNode;
}

export type OpenPage = (parts: PageParts) => Promise<void>;
