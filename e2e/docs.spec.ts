/** /docs as somebody reads it who has nothing else, and tries a call. The watch hears every complaint of the policy. */
import { AxeBuilder } from "@axe-core/playwright";
import { expect, test } from "./fixtures.ts";

test("says how to write a script, and makes the calls that it shows", async ({ page, relay }) => {
  const hosts = new Set<string>();
  page.on("request", (request) => hosts.add(new URL(request.url()).host));
  await page.goto("/docs");
  await expect(page.getByRole("heading", { name: "The life of a command" })).toBeVisible();
  const health = page.locator("#operations-Service-checkHealth");
  await health
    .getByRole("button", { name: /healthz/ })
    .first()
    .click();
  await health.getByRole("button", { name: "Execute" }).click();
  await expect(health.locator(".live-responses-table")).toContainText('"status": "ok"');
  expect([...hosts]).toEqual([new URL(relay).host]);
});

for (const colorScheme of ["light", "dark"] as const) {
  test(`can be read by everybody, in the ${colorScheme} theme and on a phone`, async ({ page }) => {
    await page.emulateMedia({ colorScheme });
    await page.setViewportSize({ width: 390, height: 844 });
    await page.goto("/docs");
    await expect(page.locator(".swagger-ui .opblock").first()).toBeVisible();
    const { violations } = await new AxeBuilder({ page }).exclude("#console").analyze();
    expect(violations.map(({ id, help }) => `${id}: ${help}`)).toEqual([]);
    const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    expect(overflow).toBeLessThanOrEqual(0);
  });
}
