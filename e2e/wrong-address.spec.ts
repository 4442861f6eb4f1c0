/** Somebody types a wrong address: the page says so in words and leads home. */
import { AxeBuilder } from "@axe-core/playwright";
import { expect, test } from "./fixtures.ts";

// Not a watched window: the browser itself notes the 404.
test("shows a page in the reader's language, with a way home", async ({ browser, relay }) => {
  const context = await browser.newContext({ baseURL: relay, locale: "de-DE" });
  const page = await context.newPage();
  const answer = await page.goto("/foo");
  expect(answer?.status()).toBe(404);
  await expect(page.getByRole("heading", { name: "Diese Seite gibt es nicht" })).toBeVisible();
  await page.setViewportSize({ width: 320, height: 640 });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(320);
  expect((await new AxeBuilder({ page }).analyze()).violations).toEqual([]);
  await page.getByRole("link", { name: "Zu Corridor" }).click();
  await expect(page).toHaveURL(`${relay}/`);
  await context.close();
});
