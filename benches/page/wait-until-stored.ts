import type { Page } from "playwright";

/**
 * Waits until the browser has stored the page for offline use. On a first visit, that takes a core
 * for seconds. It belongs to opening the page, and would disturb what is measured afterwards.
 */
export async function waitUntilStored(page: Page): Promise<void> {
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
  });
}
