/** Phones that Corridor is held in, and what only a phone has on its screen. */
import type { Locator, Page } from "playwright/test";

export const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
/** The smallest that is still about. */
export const smallest = { ...phone, viewport: { width: 320, height: 568 } };

export function tab(page: Page, name: "Drive" | "Program" | "Presets"): Locator {
  return page.getByRole("tab", { name });
}

export async function boxOf(target: Locator) {
  const box = await target.boundingBox();
  if (box === null) throw new Error("it is not on the screen");
  return box;
}
