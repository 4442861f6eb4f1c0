/** Locators of the Remote panel. */
import type { Locator, Page } from "playwright/test";

/** Opens the "More" section: key, code, watch link, scripts and the log. */
export async function openMoreSection(around: Page | Locator): Promise<void> {
  await around.locator("summary").filter({ hasText: "More" }).click();
}

/** A row of the table of running and recent commands. */
export function commandRow(page: Page, name: RegExp): Locator {
  return page.getByRole("region", { name: "Commands", exact: true }).getByRole("row", { name });
}
