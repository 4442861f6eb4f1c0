/** Parts of the screen load in the background, so that users hardly ever wait for one. */
import { expect, test } from "./fixtures.ts";

const shareDialog = /\/assets\/ShareDialog-[^/]*\.js$/;
/** requested once the page is idle and nothing is left to load in advance */
const updates = /\/assets\/offer-update-[^/]*\.js$/;

for (const { savesData, name } of [
  { savesData: false, name: "loads dialogs in advance once the page is idle" },
  { savesData: true, name: "loads no dialog in advance for a user who saves data" },
]) {
  test.describe(() => {
    test.use({ savesData });
    test(name, async ({ page }) => {
      const requested: string[] = [];
      page.on("request", (request) => requested.push(new URL(request.url()).pathname));
      await page.goto("/");
      await expect.poll(() => requested.some((path) => updates.test(path))).toBe(true);
      expect(requested.some((path) => shareDialog.test(path))).toBe(!savesData);
      await page.getByRole("button", { name: "Share", exact: true }).click();
      await expect(page.getByRole("dialog", { name: "Share" })).toBeVisible();
    });
  });
}
