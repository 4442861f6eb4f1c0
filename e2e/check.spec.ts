/** /check as an administrator sees it: in full, and where the way lets little through. */
import { AxeBuilder } from "@axe-core/playwright";
import { expect, test } from "./fixtures.ts";

test("says that all passes where all does, in the reader's language", async ({ page }) => {
  await page.goto("/check?lang=de");
  await expect(page.getByRole("status")).toHaveText(/Alles kommt durch/, { timeout: 50_000 });
  await expect(page.getByRole("listitem")).toHaveCount(11);
  await expect(page.locator("[data-state=blocked]")).toHaveCount(0);
  await page.getByRole("button", { name: "Ergebnis kopieren" }).click();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toContain("WebSocket: kommt durch");
});

test("says what is blocked and what to do", async ({ page }) => {
  await page.routeWebSocket("**/check/socket", (socket) => socket.close());
  // Not by the network: an answer that fails there is a complaint in the console.
  await page.addInitScript(() => {
    const fetched = window.fetch;
    window.fetch = (input, init) =>
      new Request(input).url.includes("/wait")
        ? Promise.reject(new Error("cut"))
        : fetched(input, init);
  });
  await page.goto("/check");
  await expect(page.getByRole("status")).toHaveText(/goes round it by itself/, { timeout: 50_000 });
  const socket = page.getByRole("listitem").filter({ hasText: "Allow the header Upgrade" });
  await expect(socket).toContainText("blocked");
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width: 390, height: 844 });
    const { violations } = await new AxeBuilder({ page }).analyze();
    expect(violations.map(({ id, help }) => `${id}: ${help}`)).toEqual([]);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(overflow).toBeLessThanOrEqual(0);
  }
  await page.getByRole("button", { name: "Check again" }).press("Enter");
  await expect(page.getByRole("status")).toBeFocused();
});
