/**
 * Every size of phone and tablet: large touch targets, and texts readable without zooming.
 */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import {
  horizontalOverflow,
  smallTouchTargets,
  unreadableTexts,
  fieldsThatZoom,
} from "./support/layout.ts";
import { phone, smallestPhone, tab } from "./support/phone.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";

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

async function expectUsable(page: Page, state: string): Promise<void> {
  await waitForAnimations(page);
  const { width, height } = page.viewportSize() ?? { width: 0, height: 0 };
  const where = `${state}, ${width} x ${height}`;
  expect(await horizontalOverflow(page), where).toEqual([]);
  expect(await smallTouchTargets(page), where).toEqual([]);
  expect(await fieldsThatZoom(page), where).toEqual([]);
  // Between the two limits, the page scrolls below its fixed footer.
  if (width < 600 || height < 600) expect(await unreadableTexts(page), where).toEqual([]);
}

async function isUsableAtEachSize(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  for (const [width, height] of sizes) {
    await page.setViewportSize({ width, height });
    await expectUsable(page, "first visit");
  }
  await corridor.step.tap();
  for (const [width, height] of sizes) {
    await page.setViewportSize({ width, height });
    await expect(corridor.timeline.slider).toBeInViewport();
    await expectUsable(page, "after a step");
  }
  for (const [width, height] of sizes.filter(([each]) => each < 600)) {
    await page.setViewportSize({ width, height });
    for (const name of ["Drive", "Presets", "Program"] as const) {
      await tab(page, name).tap();
      await expectUsable(page, name);
    }
  }
}

async function hasNoFieldThatZooms(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const expectNoZoom = async (state: string) => {
    await expect(page.locator("input, select, textarea").first()).toBeAttached();
    expect(await fieldsThatZoom(page), state).toEqual([]);
    expect(await horizontalOverflow(page), state).toEqual([]);
  };
  await expectNoZoom("program");
  await tab(page, "Presets").tap();
  await expectNoZoom("presets");
  await corridor.share.tap();
  await expect(
    corridor.dialog("Share this maze").getByRole("textbox", { name: "Link" }),
  ).toBeVisible();
  await expectNoZoom("share");
  await page.keyboard.press("Escape");
  await corridor.mazeMenu.tap();
  await expect(page.locator(":popover-open input")).toBeVisible();
  await expectNoZoom("maze menu");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "View" }).tap();
  const resize = page.locator(":popover-open").getByRole("button", { name: "Resize" });
  // A finger that touches a menu while it scrolls or moves only stops it.
  await resize.scrollIntoViewIfNeeded();
  await waitForAnimations(page);
  await resize.tap();
  await expect(corridor.dialog("Resize the maze")).toBeVisible();
  await expectNoZoom("resize");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "More", exact: true }).tap();
  await page.getByRole("button", { name: "Remote", exact: true }).tap();
  await page.getByRole("dialog").getByRole("radio", { name: "Remote" }).tap();
  await expect(page.getByRole("textbox", { name: "Script" })).toBeVisible();
  await expectNoZoom("remote");
}

test("has readable texts, large touch targets and no field that makes the phone zoom in, at each size", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  await isUsableAtEachSize(corridor);
  await corridor.page.setViewportSize(smallestPhone.viewport);
  await hasNoFieldThatZooms(corridor);
});
