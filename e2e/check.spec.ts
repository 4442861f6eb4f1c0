// cspell:words Alles funktioniert Ergebnis kopieren
/** The network check at /check, on an open network and where connections are blocked. */
import { expect, test } from "./fixtures.ts";
import { allRules, axeViolations } from "./support/axe.ts";

test("reports in the browser's language that all connections pass", async ({ page }) => {
  await page.goto("/check?lang=de");
  await expect(page.getByRole("status")).toHaveText(/Alles funktioniert/, { timeout: 50_000 });
  await expect(page.getByRole("listitem")).toHaveCount(11);
  await expect(page.locator("[data-state=blocked]")).toHaveCount(0);
  await page.getByRole("button", { name: "Ergebnis kopieren" }).click();
  const copied = await page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toContain("WebSocket: funktioniert");
});

test("reports what is blocked and how to fix it", async ({ page }) => {
  await page.routeWebSocket("**/check/socket", (socket) => socket.close());
  // Rejected in the page: a request that fails on the network is an error in the console.
  await page.addInitScript(() => {
    const originalFetch = window.fetch;
    window.fetch = (input, init) =>
      new Request(input).url.includes("/wait")
        ? Promise.reject(new Error("blocked"))
        : originalFetch(input, init);
  });
  await page.goto("/check");
  await expect(page.getByRole("status")).toHaveText(/uses other means automatically/, {
    timeout: 50_000,
  });
  const socket = page.getByRole("listitem").filter({ hasText: "Allow the header Upgrade" });
  await expect(socket).toContainText("blocked");
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width: 390, height: 844 });
    const violations = await axeViolations(page, allRules);
    expect(violations.map(({ id, help }) => `${id}: ${help}`)).toEqual([]);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(overflow).toBeLessThanOrEqual(0);
  }
  await page.getByRole("button", { name: "Check again" }).press("Enter");
  await expect(page.getByRole("status")).toBeFocused();
});
