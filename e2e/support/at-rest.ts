/** Waits for everything on the page that is on its way: colours, dialogs, notes. */
import type { Page } from "playwright/test";

export async function atRest(page: Page): Promise<void> {
  await page.evaluate(() =>
    Promise.allSettled(
      document
        .getAnimations()
        // One that follows a scroll bar has no end.
        .filter(({ timeline }) => timeline === document.timeline)
        .map((animation) => animation.finished),
    ),
  );
}
