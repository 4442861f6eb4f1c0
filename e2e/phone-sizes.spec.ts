/**
 * Every size of phone and tablet: all of it is within reach of a finger, and read without zooming
 * in.
 */
import { expect, test } from "./fixtures.ts";
import {
  horizontalOverflow,
  smallTouchTargets,
  unreadableTexts,
  fieldsThatZoom,
} from "./support/layout.ts";
import { phone, smallestPhone, tab } from "./support/phone.ts";

const sizes = [
  [320, 568],
  [360, 640],
  [390, 844],
  [414, 896],
  [667, 375],
  [844, 390],
  [600, 900],
  [768, 1024],
  [1024, 768],
] as const;
for (const [width, height] of sizes) {
  test(`reaches and reads everything with a finger at ${width} x ${height}`, async ({
    openWindow,
  }) => {
    const corridor = await openWindow({ ...phone, viewport: { width, height } });
    await corridor.open();
    const { page } = corridor;
    const expectInOrder = async (what: string) => {
      expect(await horizontalOverflow(page), what).toEqual([]);
      expect(await smallTouchTargets(page), what).toEqual([]);
      expect(await fieldsThatZoom(page), what).toEqual([]);
      // Between the two the page scrolls under its foot.
      if (width < 600 || height < 600) expect(await unreadableTexts(page), what).toEqual([]);
    };
    await expectInOrder("first visit");
    await corridor.step.tap();
    await expect(corridor.timeline.slider).toBeInViewport();
    await expectInOrder("after a step");
    if (width >= 600) return;
    for (const name of ["Drive", "Presets"] as const) {
      await tab(page, name).tap();
      await expectInOrder(name);
    }
  });
}

test("touches every field without the phone zooming in", async ({ openWindow }) => {
  const corridor = await openWindow(smallestPhone);
  await corridor.open();
  const { page } = corridor;
  const expectCalm = async (what: string) => {
    await expect(page.locator("input, select, textarea").first()).toBeAttached();
    expect(await fieldsThatZoom(page), what).toEqual([]);
    expect(await horizontalOverflow(page), what).toEqual([]);
  };
  await expectCalm("program");
  await tab(page, "Presets").tap();
  await expectCalm("presets");
  await corridor.share.tap();
  await expect(corridor.dialog("Share this maze").getByRole("textbox")).toBeVisible();
  await expectCalm("share");
  await page.keyboard.press("Escape");
  await corridor.mazeMenu.tap();
  await expect(page.locator(":popover-open input")).toBeVisible();
  await expectCalm("maze menu");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "View" }).tap();
  await page.locator(":popover-open").getByRole("button", { name: "Resize" }).tap();
  await expect(corridor.dialog("Resize the maze")).toBeVisible();
  await expectCalm("resize");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "More", exact: true }).tap();
  await page.getByRole("button", { name: "Remote", exact: true }).tap();
  await page.getByRole("dialog").getByRole("radio", { name: "Remote" }).tap();
  await expect(page.getByRole("textbox", { name: "Script" })).toBeVisible();
  await expectCalm("remote");
});
