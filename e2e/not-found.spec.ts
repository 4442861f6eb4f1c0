// cspell:words Diese Seite gibt nicht
/** The page for unknown addresses, with a link to the start page. */
import { expect, test } from "./fixtures.ts";
import { allRules, axeViolations } from "./support/axe.ts";

// Not an openWindow fixture: the browser logs an error for the 404.
test("shows a page in the browser's language, with a link to the start page", async ({
  browser,
  relay,
}) => {
  const context = await browser.newContext({ baseURL: relay, locale: "de-DE" });
  const page = await context.newPage();
  const response = await page.goto("/foo");
  expect(response?.status()).toBe(404);
  await expect(page.getByRole("heading", { name: "Diese Seite gibt es nicht" })).toBeVisible();
  await page.setViewportSize({ width: 320, height: 640 });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  expect(await axeViolations(page, allRules)).toEqual([]);
  await page.getByRole("link", { name: "Zu Corridor" }).click();
  await expect(page).toHaveURL(`${relay}/`);
  await context.close();
});
