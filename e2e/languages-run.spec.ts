/**
 * Texts fit in every language in what appears during use: a mission with its hints, the bump and
 * solved cards, the past, the tape measure and the file dialogs. In a right-to-left language,
 * comparisons, addresses and numbers still read left to right.
 */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { chooseLanguage } from "./support/choose-language.ts";
import { unreadableTexts } from "./support/layout.ts";
import { languageTags, Texts } from "./support/texts.ts";
import { smallWindow } from "./support/window-sizes.ts";

const sizes = [
  { width: 320, height: 640 },
  { width: 1024, height: 768 },
];

const tags = languageTags();

for (const size of sizes) {
  // Languages share a page, in which the language changes.
  for (const group of [tags.slice(0, 4), tags.slice(4)]) {
    test(`shows readable texts during use in ${group.join(", ")} at ${size.width} x ${size.height}`, async ({
      openWindow,
    }) => {
      test.setTimeout(group.length * 120_000);
      const isPhone = size.width < 600;
      const { page } = await openWindow({
        viewport: size,
        hasTouch: isPhone,
        isMobile: isPhone,
        serviceWorkers: "block",
        reducedMotion: "reduce",
      });
      const faults: string[] = [];
      for (const [at, tag] of group.entries()) {
        const shown = group[at - 1];
        if (shown === undefined) await page.goto(`/?lang=${tag}`);
        else await chooseLanguage(page, Texts.load(shown), tag);
        const found = await faultsDuringUse(page, tag, isPhone);
        faults.push(...found.map((fault) => `${tag}: ${fault}`));
      }
      expect(faults).toEqual([]);
    });
  }
}

/**
 * Bumps, solves the maze, opens what appears during use, and leaves the page as at the beginning.
 * @returns the texts that cannot be read
 */
async function faultsDuringUse(page: Page, tag: string, isPhone: boolean): Promise<string[]> {
  const texts = Texts.load(tag);
  const faults: string[] = [];
  const checkTexts = async (state: string, root = "body"): Promise<void> => {
    await waitForAnimations(page);
    faults.push(...(await unreadableTexts(page, root)).map((fault) => `${state}: ${fault}`));
  };
  const button = (path: string, values = {}): Locator =>
    page.getByRole("button", { name: texts.t(path, values), exact: true });
  const dialog = page.locator("dialog[open]");
  const card = page.locator("[data-card]");
  const direction = tag === "ar" ? "rtl" : "ltr";

  await page.getByRole("grid").waitFor();
  const action = page.getByRole("combobox", { name: texts.t("program.actionOf", { line: 2 }) });
  await page.getByRole("combobox", { name: texts.t("shell.run.speed") }).selectOption("max");
  await action.selectOption("delayed left 90");
  await button("shell.run.run").click();
  await expect(card).toBeVisible();
  await checkTexts("bump", "[data-card]");
  // The card is on the stage, which is never mirrored. The card's text is.
  await expect(card).toHaveCSS("direction", direction);
  await button("timeline.stepBack").click();
  await expect(button("timeline.backToNow")).toBeVisible();
  await checkTexts("past", "section[data-view]");
  await button("timeline.backToNow").click();
  await expect(card).toBeVisible();
  await card.getByRole("button").last().press("Escape");
  await action.selectOption("left 90");
  await button("shell.run.reset").click();
  await button("shell.run.run").click();
  await expect(card).toContainText(texts.t("cards.solved.title"));
  await checkTexts("solved", "[data-card]");
  await card.getByRole("button").last().press("Escape");

  await page.getByRole("radio", { name: texts.t("stage.tool.measure"), exact: true }).click();
  await page.getByRole("gridcell").first().focus();
  for (const key of ["Space", "ArrowRight", "ArrowDown", "Space"]) {
    await page.keyboard.press(key);
  }
  await checkTexts("measure");

  const menu = page.getByRole("button", { name: texts.t("projects.menu") });
  await menu.click();
  await checkTexts("maze menu");
  await button("files.savePicture").click();
  await expect(dialog).toBeVisible();
  await checkTexts("picture");
  await page.keyboard.press("Escape");
  await page.evaluate((text) => navigator.clipboard.writeText(text), `{"format":"corridor/maze"}`);
  await page.getByRole("banner").click({ position: { x: 2, y: 2 } });
  await page.keyboard.press("ControlOrMeta+V");
  await expect(dialog).toBeVisible();
  await checkTexts("file problems");
  await page.keyboard.press("Escape");

  if (isPhone) await button("shell.more").click();
  await page.getByRole("button", { name: texts.t("lessons.lessons"), exact: true }).click();
  await expect(dialog).toBeVisible();
  await checkTexts("lessons");
  await dialog
    .getByRole("button")
    .filter({ hasText: texts.t("missions.missions.farthest-distance.name") })
    .click();
  const mission = page.getByRole("region", {
    name: texts.t("missions.card.label"),
    exact: true,
  });
  await expect(mission).toContainText(texts.t("missions.missions.farthest-distance.task"));
  await mission.getByRole("button", { name: texts.t("missions.card.hint") }).click();
  await checkTexts("mission");
  await mission.getByRole("button", { name: texts.t("missions.card.own") }).click();
  await mission.waitFor({ state: "detached" });
  await page.getByRole("radio", { name: texts.t("stage.tool.blocks"), exact: true }).click();
  await button("shell.run.reset").click();
  return faults;
}

test("writes a comparison in reading direction in English and Arabic, and a minus sign before the digits", async ({
  openWindow,
}) => {
  const { page } = await openWindow(smallWindow);
  const english = Texts.load("en");
  await page.goto("/?lang=en");
  await page
    .getByRole("combobox", { name: english.t("program.conditionOf", { line: 1 }) })
    .selectOption({ label: comparisonIn(english) });
  await page.getByRole("textbox", { name: english.t("program.numberOf", { line: 1 }) }).fill("-20");
  await expectReadingDirection(page, english, 1);
  await chooseLanguage(page, english, "ar");
  await expectReadingDirection(page, Texts.load("ar"), -1);
});

function comparisonIn(texts: Texts): string {
  return `${texts.t("program.sensor.left")} > ${texts.t("program.sensor.right")} +`;
}

/**
 * Expects line 1 to compare 50 with 30, from its start to its end.
 * @param dir 1 from left to right, -1 from right to left
 */
async function expectReadingDirection(page: Page, texts: Texts, dir: 1 | -1): Promise<void> {
  const condition = page.getByRole("combobox", {
    name: texts.t("program.conditionOf", { line: 1 }),
  });
  await expect(condition.locator("option:checked")).toHaveText(comparisonIn(texts));
  const number = page.getByRole("textbox", { name: texts.t("program.numberOf", { line: 1 }) });
  const line = page.getByRole("listitem").filter({ has: number });
  // 50 cm on the left and on the right: the condition compares 50 with 30.
  await expect(line).toContainText(/50\s*> 30/);
  const readingOrder = async () => {
    const tokens = await line.evaluate((item) => {
      const centreOf = (rect: DOMRect): number => rect.left + rect.width / 2;
      const walker = document.createTreeWalker(item, NodeFilter.SHOW_TEXT);
      const found: { text: string; at: number }[] = [];
      for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
        for (const { index, 0: text } of (node.textContent ?? "").matchAll(/[<>]|\d+/g)) {
          const range = document.createRange();
          range.setStart(node, index);
          range.setEnd(node, index + text.length);
          const rect = range.getBoundingClientRect();
          if (rect.width > 0) found.push({ text, at: centreOf(rect) });
        }
      }
      return found;
    });
    const truth = tokens.filter(({ text }) => ["50", ">", "30"].includes(text)).slice(-3);
    return truth.toSorted((one, other) => (one.at - other.at) * dir).map(({ text }) => text);
  };
  // The fallback font is wider until the web font has loaded.
  await expect.poll(readingOrder).toEqual(["50", ">", "30"]);
  const [conditionBox, numberBox] = [await condition.boundingBox(), await number.boundingBox()];
  expect(((numberBox?.x ?? 0) - (conditionBox?.x ?? 0)) * dir).toBeGreaterThan(0);
  await expect(number).toHaveCSS("direction", "ltr");
}
