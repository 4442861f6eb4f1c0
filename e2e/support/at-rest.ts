/** Waits for everything on the page that is on its way: colours, dialogs, notes. */
import type { Page } from "playwright/test";

export async function atRest(page: Page): Promise<void> {
  await page.evaluate(async () => {
    await Promise.allSettled(
      document
        .getAnimations()
        // One that follows a scroll bar has no end.
        .filter(({ timeline }) => timeline === document.timeline)
        .map((animation) => animation.finished),
    );
    // What has just come, a font or a late part, is placed in the frame that shows it: between frames nobody looks.
    for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
  });
}
