/** Makes each load of a page the first visit, as in a new window. */
import type { Page } from "playwright/test";

/** Deletes what the page has stored before each load: its projects, settings and progress. */
export async function clearStorageOnLoad(page: Page): Promise<void> {
  await page.addInitScript(() => {
    localStorage.clear();
    sessionStorage.clear();
  });
}
