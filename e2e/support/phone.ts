/** Phone viewports, and locators of controls that only the phone layout has. */
import type { Locator, Page } from "playwright/test";

export const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
/** The smallest phone in use. */
export const smallestPhone = { ...phone, viewport: { width: 320, height: 568 } };

export function tab(page: Page, name: "Drive" | "Program" | "Presets"): Locator {
  return page.getByRole("tab", { name });
}

export async function boxOf(target: Locator) {
  const box = await target.boundingBox();
  if (box === null) throw new Error("the element is not on the screen");
  return box;
}
