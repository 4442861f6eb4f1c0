/** The robot in the page does all that scripts rely on, as the conformance kit asks any host. */
import { join } from "node:path";
import { expect, test } from "./fixtures.ts";
import { runScript } from "./support/script.ts";

const KIT = join(import.meta.dirname, "../apps/conformance/src/main.ts");

test("the robot in the page passes the conformance kit", async ({ page }) => {
  test.setTimeout(180_000);
  await page.goto("/");
  await page.getByRole("radio", { name: "Remote" }).click();
  await page.getByRole("button", { name: "Copy address with key" }).click();
  const address = await page.evaluate(() => navigator.clipboard.readText());
  const { code, output } = await runScript([process.execPath, KIT, address]);
  expect(output).toMatch(/\n\d+ passed, 0 failed\n$/);
  expect(code).toBe(0);
});
