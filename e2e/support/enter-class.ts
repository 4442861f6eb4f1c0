/** A student's page that joins a class. */
import { expect, type Locator, type Page } from "playwright/test";
import { CorridorPage } from "../pages/corridor-page.ts";

/** Joins with the code, and opens the student's page. */
export async function enterClass(page: Page, code: string, origin = ""): Promise<CorridorPage> {
  await page.goto(`${origin}/join#${code}`);
  await page.getByRole("button", { name: "Join" }).click();
  await page.getByRole("link", { name: "Start" }).click();
  const corridor = new CorridorPage(page);
  await corridor.waitUntilReady();
  await expect(classButton(page)).toBeVisible();
  return corridor;
}

/** The button with the student's name, which opens the class menu. */
export function classButton(page: Page): Locator {
  return page.getByRole("button", { name: /, in class/ });
}
