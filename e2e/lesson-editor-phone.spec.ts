/** The lesson editor on a phone, and sharing a lesson there. */
import { encodeLink } from "@corridor/link";
import type { Page } from "playwright/test";
import { sampleLesson } from "../apps/web/src/features/teach/testing/sample-lesson.ts";
import { expect, test } from "./fixtures.ts";
import { allButColours, axeViolations, expectNoAxeViolations } from "./support/axe.ts";
import { chooseLanguage } from "./support/choose-language.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { phone } from "./support/phone.ts";
import { Texts } from "./support/texts.ts";
import { wideWindow } from "./support/window-sizes.ts";

const link = encodeLink({ lesson: sampleLesson });

test("shares a lesson from a phone as a short link, a picture, a file and with other apps, and fits it, also at 320 px in a right-to-left language", async ({
  openWindow,
}) => {
  const { page } = await openWindow(phone);
  await test.step("shares a lesson", () => shareFromPhone(page));
  const main = page.getByRole("main");
  await page.goto("/teach#make");
  await expect(main.getByRole("textbox")).toBeVisible();
  await expectNoAxeViolations(page, "beginnings");
  await page.goto(`/teach#${link.ok ? link.text : ""}`);
  await expectEditorFits(page, "English", (state) => expectNoAxeViolations(page, state));

  await page.setViewportSize(wideWindow.viewport);
  await chooseLanguage(page, Texts.load("en"), "ar");
  await page.setViewportSize(phone.viewport);
  // Both languages have the same colours.
  const expectAccessible = async (state: string): Promise<void> =>
    expect(await axeViolations(page, allButColours), state).toEqual([]);
  await expectEditorFits(page, "Arabic", expectAccessible);
  await page.goto("/teach#make");
  await expect(main.getByRole("textbox")).toBeVisible();
  await expectAccessible("Arabic beginnings");
});

async function shareFromPhone(page: Page): Promise<void> {
  // Headless browsers have no share sheet.
  await page.addInitScript(() => {
    Reflect.set(navigator, "share", (data: ShareData) => {
      document.documentElement.dataset["shared"] = data.url;
      return Promise.resolve();
    });
  });
  const intro = Array.from({ length: 190 }, (_, at) => (at ** 3 % 997).toString(36)).join("");
  const long = encodeLink({ lesson: { ...sampleLesson, intro } });
  await page.goto(`/teach#${long.ok ? long.text : ""}`);
  await expect(page).toHaveURL(/#lesson=/);
  await page.goto("/teach#");
  const share = page.getByRole("button", { name: "Share", exact: true });
  await share.click();
  const dialog = page.getByRole("dialog", { name: "Share lesson" });
  await dialog.getByRole("button", { name: "Share anyway" }).click();
  const field = dialog.getByRole("textbox", { name: "Link" });
  await expect(field).toHaveValue(/\/#\S+$/);
  const classroom = dialog.getByRole("link", { name: "Google Classroom" });
  // A long link never enters a query string.
  await expect(dialog).toContainText(
    "The link is too long for a QR code and for Google Classroom.",
  );
  await expect(classroom).toHaveCount(0);

  await dialog.getByRole("button", { name: "Short link", exact: true }).click();
  await expect(field).toHaveValue(/\/m\/[A-Z]{4,6}$/);
  const short = await field.inputValue();
  await expect(classroom).toHaveAttribute(
    "href",
    `https://classroom.google.com/share?url=${encodeURIComponent(short)}`,
  );
  await dialog.getByRole("button", { name: "Share with an app" }).click();
  await expect(page.locator("html")).toHaveAttribute("data-shared", short);
  for (const [button, file] of [
    ["Save picture", "two-tasks.svg"],
    ["Save as a file", "two-tasks.lesson.json"],
  ] as const) {
    const download = page.waitForEvent("download");
    await dialog.getByRole("button", { name: button }).click();
    expect((await download).suggestedFilename()).toBe(file);
  }
  await expect(dialog.getByRole("figure", { name: "QR code of the link" })).toBeVisible();
  await expectNoAxeViolations(page, "share");
  // Behind the dialog, the whole row of a saved lesson is a link, not only its name.
  const small = await smallTouchTargets(page);
  expect(small.filter((target) => !target.startsWith("Two tasks:"))).toEqual([]);
  await page.setViewportSize({ width: 320, height: 640 });
  await expect.poll(() => horizontalOverflow(page)).toEqual([]);

  await page.context().setOffline(true);
  await expect(dialog).toContainText("You are offline.");
  await page.keyboard.press("Escape");
  await expect(share).toBeFocused();
  await page.context().setOffline(false);
  await page.setViewportSize(phone.viewport);
}

/** Opens each tab of the lesson that is open on a phone. */
async function expectEditorFits(
  page: Page,
  language: string,
  expectAccessible: (state: string) => Promise<void>,
): Promise<void> {
  const tabs = page.getByRole("tab");
  await expect(tabs).toHaveCount(4);
  for (const at of [0, 1, 2, 3]) {
    const state = `${language}, tab ${at}`;
    await tabs.nth(at).click();
    await expectAccessible(state);
    expect(await smallTouchTargets(page), state).toEqual([]);
    for (const width of [390, 320]) {
      await page.setViewportSize({ width, height: 640 });
      await expect.poll(() => horizontalOverflow(page), `${state}, ${width} px`).toEqual([]);
    }
  }
}
