/**
 * Large fonts, a page zoom of 400 % and forced colours: all content is visible and usable.
 */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { horizontalOverflow, unreadableTexts } from "./support/layout.ts";

/** Doubles the browser's default font size, as its settings do. */
async function doubleFontSize(page: Page): Promise<void> {
  const browser = await page.context().newCDPSession(page);
  await browser.send("Page.enable");
  await browser.send("Page.setFontSizes", { fontSizes: { standard: 32, fixed: 26 } });
}

for (const { width, height, isPhone } of [
  { width: 1440, height: 900, isPhone: false },
  // In units of the font as wide as a phone, and low: the page scrolls as a whole.
  { width: 1024, height: 768, isPhone: true },
  { width: 390, height: 844, isPhone: true },
]) {
  test(`shows readable texts at a font size of 200 % at ${width} x ${height}`, async ({
    openWindow,
  }) => {
    const corridor = await openWindow({ viewport: { width, height } });
    const { page } = corridor;
    await doubleFontSize(page);
    await corridor.open();
    const faults: string[] = [];
    const checkTexts = async (state: string): Promise<void> => {
      await waitForAnimations(page);
      const found = [...(await horizontalOverflow(page)), ...(await unreadableTexts(page))];
      faults.push(...found.map((fault) => `${state}: ${fault}`));
    };
    const checkOverlay = async (state: string, open: () => Promise<void>): Promise<void> => {
      await open();
      await expect(page.locator("dialog[open], :popover-open")).not.toHaveCount(0);
      await checkTexts(state);
      await page.keyboard.press("Escape");
    };
    await checkTexts("first visit");
    await checkOverlay("keys", () => page.keyboard.press("?"));
    await checkOverlay("share", () => corridor.share.click());
    await checkOverlay("view", () => page.getByRole("button", { name: "View" }).click());
    await checkOverlay("maze", () => corridor.mazeMenu.click());
    await corridor.run.click();
    await expect(corridor.timeline.slider).toBeVisible();
    await expect(corridor.bumps).toBeAttached();
    await corridor.pause.click();
    await checkTexts("after a run");
    await corridor.timeline.slider.press("Home");
    await expect(corridor.timeline.pastLabel).toBeVisible();
    await checkTexts("past");
    await corridor.timeline.backToNow.click();
    if (isPhone) {
      for (const tab of ["Drive", "Presets", "Program"]) {
        await page.getByRole("tab", { name: tab }).click();
        await checkTexts(tab);
      }
    }
    expect(faults).toEqual([]);
    for (const control of [
      corridor.run,
      corridor.step,
      corridor.share,
      corridor.program.line(1),
      corridor.program.otherwise,
      corridor.program.button("Add line"),
      corridor.maze.grid,
    ]) {
      await control.scrollIntoViewIfNeeded();
      await expect(control).toBeInViewport();
    }
  });
}

test("shows readable texts where a user style doubles the font size", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 1440, height: 900 } });
  await corridor.open();
  const { page } = corridor;
  await page.evaluate(() => document.documentElement.style.setProperty("font-size", "200%"));
  expect(await horizontalOverflow(page)).toEqual([]);
  await corridor.run.scrollIntoViewIfNeeded();
  await expect(corridor.run).toBeInViewport();
  await corridor.program.line(1).scrollIntoViewIfNeeded();
  await expect(corridor.program.line(1)).toBeInViewport();
});

test("is usable at 400 %, when a window of 1280 x 1024 has 320 x 256 px", async ({
  openWindow,
}) => {
  const corridor = await openWindow({ viewport: { width: 320, height: 256 } });
  await corridor.open();
  const { page } = corridor;
  expect(await horizontalOverflow(page), "first visit").toEqual([]);
  for (const control of [
    corridor.maze.grid,
    corridor.run,
    corridor.step,
    corridor.share,
    corridor.program.line(1),
    corridor.program.otherwise,
    corridor.program.button("Add line"),
  ]) {
    await control.scrollIntoViewIfNeeded();
    await expect(control).toBeInViewport();
  }
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
});

test("a dashboard is usable at 400 %", async ({ openWindow, relay }) => {
  const { page } = await openWindow({ viewport: { width: 320, height: 256 } });
  const teacher = await ClassTeacher.start(relay, ["A name of 24 letters wow"]);
  const dashboard = new DashboardPage(page);
  const faults: string[] = [];
  const check = async (state: string): Promise<void> => {
    await waitForAnimations(page);
    const found = [...(await horizontalOverflow(page)), ...(await unreadableTexts(page))];
    faults.push(...found.map((fault) => `${state}: ${fault}`));
  };
  const button = (name: string) => page.getByRole("button", { name, exact: true });
  await page.goto(teacher.address());
  await expect(dashboard.code).toContainText("No student has joined yet.");
  await check("nobody has joined");
  const student = await ScriptedStudent.join(relay, teacher.code);
  student.askForHelp();
  await expect(dashboard.cards).toHaveAccessibleName(/Asked for help/);
  await check("a card");
  const sorting = page.getByRole("combobox", { name: "Sort by" });
  for (const control of [sorting, button("Who can join"), dashboard.cards]) {
    await control.scrollIntoViewIfNeeded();
    await expect(control).toBeInViewport();
  }
  await expect(button("Pause everyone (5 min)")).toBeInViewport();
  await button("More").click();
  const more = page.getByRole("dialog", { name: "More" });
  for (const name of ["End lesson", "Theme"]) {
    const control = more.getByRole("button", { name, exact: true });
    await control.scrollIntoViewIfNeeded();
    await expect(control).toBeInViewport();
  }
  await page.keyboard.press("Escape");
  await dashboard.cards.click();
  for (const name of ["Close", "Return code", "Remove"]) {
    await button(name).scrollIntoViewIfNeeded();
    await expect(button(name)).toBeInViewport();
  }
  expect(await horizontalOverflow(page), "watched student").toEqual([]);
  expect(faults).toEqual([]);
  student.close();
});

test("shows the cards of a dashboard in forced colours", async ({ page, relay }) => {
  const teacher = await ClassTeacher.start(relay, ["Team 1"]);
  const { cards } = new DashboardPage(page);
  await page.emulateMedia({ forcedColors: "active" });
  await page.goto(teacher.address());
  const student = await ScriptedStudent.join(relay, teacher.code);
  student.askForHelp();
  await expect(cards).toHaveAccessibleName(/Asked for help/);
  await page.keyboard.press("n");
  await expect(cards).toBeFocused();
  const drawn = await cards.evaluate((card) => {
    const chip = [...(card.parentElement?.querySelectorAll("span") ?? [])].find(
      (each) => each.textContent === "Asked for help" && each.querySelector("svg") !== null,
    );
    const borders = [card.parentElement, chip].map((each) =>
      each ? Number.parseFloat(getComputedStyle(each).borderTopWidth) : 0,
    );
    return { borders, outline: Number.parseFloat(getComputedStyle(card).outlineWidth) };
  });
  expect(drawn.borders).toEqual([1, 1]);
  expect(drawn.outline).toBeGreaterThanOrEqual(2);
  student.close();
});

test("shows focus, selection and state in forced colours", async ({ corridor, page }) => {
  await page.emulateMedia({ forcedColors: "active" });
  await page.keyboard.press("Tab");
  const outline = await page.evaluate(() => {
    const { outlineStyle, outlineWidth } = getComputedStyle(
      document.activeElement ?? document.body,
    );
    return { outlineStyle, width: Number.parseFloat(outlineWidth) };
  });
  expect(outline.outlineStyle).not.toBe("none");
  expect(outline.width).toBeGreaterThanOrEqual(2);
  await corridor.program.action(2).selectOption("delayed left 90");
  await corridor.speed.selectOption("4×");
  await corridor.run.click();
  const card = corridor.bumpCard(2);
  await expect(card).toBeVisible();
  // A surface has a border where its background colour is removed.
  const edges = await card.evaluate((element) => {
    const { borderTopWidth, borderTopStyle, outlineStyle } = getComputedStyle(element);
    return Number.parseFloat(borderTopWidth) > 0 && borderTopStyle !== "none"
      ? "border"
      : outlineStyle;
  });
  expect(edges).not.toBe("none");
});
