/** The Remote panel as its user goes about it. */
import type { Locator, Page } from "playwright/test";

/** Opens what is one step further: key, code, watch link, other languages, scripts and the log. */
export async function openMore(around: Page | Locator): Promise<void> {
  await around.locator("summary").filter({ hasText: "More" }).click();
}

/** A row of the running and the last commands. */
export function commandRow(page: Page, name: RegExp): Locator {
  return page.getByRole("region", { name: "Commands", exact: true }).getByRole("row", { name });
}
