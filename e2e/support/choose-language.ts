/** Chooses a language in the menu of an open page, which costs far less than loading the page again. */
import type { Page } from "playwright/test";
import type { Texts } from "./texts.ts";

/** Narrower pages have the languages in the menu "More". */
const WIDE = 900;

/** @param shown the texts of the language that the page displays */
export async function chooseLanguage(page: Page, shown: Texts, tag: string): Promise<void> {
  if ((page.viewportSize()?.width ?? 0) >= WIDE) return chooseInLanguageMenu(page, shown, tag);
  const more = page
    .getByRole("banner")
    .getByRole("button", { name: shown.t("shell.more"), exact: true });
  await more.click();
  await page.getByRole("combobox", { name: shown.t("language.language") }).selectOption(tag);
  await page.keyboard.press("Escape");
  await waitForLanguage(page, tag);
}

/** For a page whose bar has the menu of languages at any width. */
export async function chooseInLanguageMenu(page: Page, shown: Texts, tag: string): Promise<void> {
  const name = shown.t("language.language");
  await page.getByRole("banner").getByRole("button", { name }).click();
  await page.locator(`[role=menuitemradio][lang="${tag}"]`).click();
  await waitForLanguage(page, tag);
}

async function waitForLanguage(page: Page, tag: string): Promise<void> {
  await page.locator(`html[lang="${tag}"]`).waitFor();
  await page.locator("dialog[open], :popover-open").waitFor({ state: "detached" });
}
