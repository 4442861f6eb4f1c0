/**
 * Large fonts, a page zoom of 400 % and forced colours: all content is visible and usable.
 */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { DashboardPage } from "./pages/dashboard-page.ts";
import { ClassTeacher } from "./support/class-teacher.ts";
import { ScriptedStudent } from "./support/scripted-student.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { horizontalOverflow, unreadableTexts } from "./support/layout.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

/** Sets the browser's default font size in percent, as its settings do. */
async function setFontSize(page: Page, percent: number): Promise<void> {
  const browser = await page.context().newCDPSession(page);
  await browser.send("Page.enable");
  const [standard, fixed] = [(16 * percent) / 100, (13 * percent) / 100];
  await browser.send("Page.setFontSizes", { fontSizes: { standard, fixed } });
}

/** Collects what cannot be read on a page in its states. */
class Readability {
  readonly faults: string[] = [];
  readonly #page: Page;

  constructor(page: Page) {
    this.#page = page;
  }

  async check(state: string): Promise<void> {
    await waitForAnimations(this.#page);
    const found = [
      ...(await horizontalOverflow(this.#page)),
      ...(await unreadableTexts(this.#page)),
    ];
    this.faults.push(...found.map((fault) => `${state}: ${fault}`));
  }
}

async function expectReachable(controls: readonly Locator[]): Promise<void> {
  for (const control of controls) {
    await control.scrollIntoViewIfNeeded();
    await expect(control).toBeInViewport();
  }
}

function controlsOf({ run, step, share, program, maze }: CorridorPage): Locator[] {
  return [
    run,
    step,
    share,
    program.line(1),
    program.otherwise,
    program.button("Add line"),
    maze.grid,
  ];
}

const screens = [
  { width: 1440, height: 900, isPhone: false },
  // In units of the font as wide as a phone, and low: the page scrolls as a whole.
  { width: 1024, height: 768, isPhone: true },
  { width: 390, height: 844, isPhone: true },
];

async function showsReadableTexts(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const readability = new Readability(page);
  const checkOverlay = async (state: string, open: () => Promise<void>): Promise<void> => {
    await open();
    await expect(page.locator("dialog[open], :popover-open")).not.toHaveCount(0);
    await readability.check(state);
    await page.keyboard.press("Escape");
  };
  for (const { width, height } of screens) {
    await page.setViewportSize({ width, height });
    await readability.check(`first visit, ${width} px`);
    await checkOverlay(`keys, ${width} px`, () => page.keyboard.press("?"));
    await checkOverlay(`share, ${width} px`, () => corridor.share.click());
    const view = page.getByRole("button", { name: "View" });
    await checkOverlay(`view, ${width} px`, () => view.click());
    await checkOverlay(`maze, ${width} px`, () => corridor.mazeMenu.click());
  }
  await corridor.run.click();
  await expect(corridor.timeline.slider).toBeVisible();
  await expect(corridor.bumps).toBeAttached();
  await corridor.pause.click();
  for (const { width, height, isPhone } of screens) {
    await page.setViewportSize({ width, height });
    await readability.check(`after a run, ${width} px`);
    await corridor.timeline.slider.press("Home");
    await expect(corridor.timeline.pastLabel).toBeVisible();
    await readability.check(`past, ${width} px`);
    await corridor.timeline.backToNow.click();
    for (const tab of isPhone ? ["Drive", "Presets", "Program"] : []) {
      await page.getByRole("tab", { name: tab }).click();
      await readability.check(`${tab}, ${width} px`);
    }
    await expectReachable(controlsOf(corridor));
  }
  expect(readability.faults).toEqual([]);
}

async function showsFocusAndState(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
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
  await corridor.speed.selectOption("max");
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
}

test("is readable and usable with large fonts, at 400 % and in forced colours", async ({
  page,
}) => {
  const corridor = new CorridorPage(page);
  await test.step("shows readable texts at a font size of 200 %", async () => {
    await setFontSize(page, 200);
    await corridor.open();
    await showsReadableTexts(corridor);
    await setFontSize(page, 100);
    await corridor.reset.click();
  });
  await test.step("is usable where a user style doubles the font size", async () => {
    await page.setViewportSize({ width: 1440, height: 900 });
    await page.evaluate(() => document.documentElement.style.setProperty("font-size", "200%"));
    expect(await horizontalOverflow(page)).toEqual([]);
    await expectReachable([corridor.run, corridor.program.line(1)]);
    await page.evaluate(() => document.documentElement.style.removeProperty("font-size"));
  });
  await test.step("is usable at 400 %, when a window of 1280 x 1024 has 320 x 256 px", async () => {
    await page.setViewportSize({ width: 320, height: 256 });
    expect(await horizontalOverflow(page), "first visit").toEqual([]);
    await expectReachable(controlsOf(corridor));
    await corridor.run.click();
    await expect(corridor.pause).toBeVisible();
    await corridor.reset.click();
  });
  await test.step("shows focus, selection and state in forced colours", async () => {
    await page.setViewportSize(smallWindow.viewport);
    await page.emulateMedia({ forcedColors: "active" });
    await showsFocusAndState(corridor);
  });
});

async function dashboardIsUsable(dashboard: DashboardPage): Promise<void> {
  const { page } = dashboard;
  const button = (name: string) => page.getByRole("button", { name, exact: true });
  const sorting = page.getByRole("combobox", { name: "Sort by" });
  await expectReachable([sorting, button("Who can join"), dashboard.cards]);
  await expect(button("Pause everyone (5 min)")).toBeInViewport();
  await button("More").click();
  const more = page.getByRole("dialog", { name: "More" });
  await expectReachable(
    ["End lesson", "Theme"].map((name) => more.getByRole("button", { name, exact: true })),
  );
  await page.keyboard.press("Escape");
  await dashboard.cards.click();
  await expectReachable(["Close", "Return code", "Remove"].map(button));
  expect(await horizontalOverflow(page), "watched student").toEqual([]);
  await button("Close").click();
}

async function showsCardsInForcedColours({ page, cards }: DashboardPage): Promise<void> {
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
}

test("a dashboard is usable at 400 %, and shows its cards in forced colours", async ({
  page,
  relay,
}) => {
  await page.setViewportSize({ width: 320, height: 256 });
  const teacher = await ClassTeacher.start(relay, ["A name of 24 letters wow"]);
  const dashboard = new DashboardPage(page);
  const readability = new Readability(page);
  await page.goto(teacher.address());
  await expect(dashboard.code).toContainText("No student has joined yet.");
  await readability.check("nobody has joined");
  const student = await ScriptedStudent.join(relay, teacher.code);
  student.askForHelp();
  await expect(dashboard.cards).toHaveAccessibleName(/Asked for help/);
  await readability.check("a card");
  expect(readability.faults).toEqual([]);
  await dashboardIsUsable(dashboard);
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.emulateMedia({ forcedColors: "active" });
  await showsCardsInForcedColours(dashboard);
  student.close();
});
