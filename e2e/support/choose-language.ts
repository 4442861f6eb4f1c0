/** Chooses a language in the menu of an open page, which costs far less than loading the page again. */
import type { Page } from "playwright/test";
import type { Texts } from "./texts.ts";

/** Narrower pages have the languages in the menu "More". */
const WIDE = 900;

/** @param shown the texts of the language that the page displays */
export async function chooseLanguage(page: Page, shown: Texts, tag: string): Promise<void> {
  const banner = page.getByRole("banner");
  const name = shown.t("language.language");
  if ((page.viewportSize()?.width ?? 0) < WIDE) {
    await banner.getByRole("button", { name: shown.t("shell.more"), exact: true }).click();
    await page.getByRole("combobox", { name }).selectOption(tag);
    await page.keyboard.press("Escape");
  } else {
    await banner.getByRole("button", { name }).click();
    await page.locator(`[role=menuitemradio][lang="${tag}"]`).click();
  }
  await page.locator(`html[lang="${tag}"]`).waitFor();
  await page.locator("dialog[open], :popover-open").waitFor({ state: "detached" });
}
