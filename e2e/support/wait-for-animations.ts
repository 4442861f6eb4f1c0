/** Waits until all animations of the page have finished: colours, dialogs, notes. */
import type { Page } from "playwright/test";

/** A longer animation is not a transition: a clock runs for a minute. */
const LONGEST_MS = 5_000;

export async function waitForAnimations(page: Page): Promise<void> {
  await page.evaluate(async (longest) => {
    await Promise.allSettled(
      document
        .getAnimations()
        // A scroll-driven animation never finishes.
        .filter(({ timeline }) => timeline === document.timeline)
        .filter(({ effect }) => Number(effect?.getComputedTiming().endTime ?? 0) <= longest)
        .map((animation) => animation.finished),
    );
    // A font or a lazy-loaded part gets its layout in the next frame. Wait for two frames.
    for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
  }, LONGEST_MS);
}
