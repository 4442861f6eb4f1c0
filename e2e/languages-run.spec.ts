/**
 * Every language has room in what comes while someone works: a mission with its hints, the cards of
 * a bump and of a solved maze, the past, the tape measure and the dialogs of files. And in a
 * language that runs right-to-left, what is a comparison, an address or a number still reads as
 * one.
 */
import type { Locator } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { unreadableTexts } from "./support/layout.ts";
import { languageTags, Texts } from "./support/texts.ts";

const sizes = [
  { width: 320, height: 640 },
  { width: 1024, height: 768 },
];

for (const tag of languageTags()) {
  for (const size of sizes) {
    test(`works in ${tag} at ${size.width} x ${size.height} and reads everything`, async ({
      openWindow,
    }) => {
      const isPhone = size.width < 600;
      const { page } = await openWindow({
        viewport: size,
        hasTouch: isPhone,
        isMobile: isPhone,
        serviceWorkers: "block",
        reducedMotion: "reduce",
      });
      const words = Texts.load(tag);
      const faults: string[] = [];
      const look = async (state: string, root = "body"): Promise<void> => {
        await waitForAnimations(page);
        faults.push(...(await unreadableTexts(page, root)).map((fault) => `${state}: ${fault}`));
      };
      const button = (path: string, values = {}): Locator =>
        page.getByRole("button", { name: words.t(path, values), exact: true });
      const dialog = page.locator("dialog[open]");
      const card = page.locator("[data-card]");
      const direction = tag === "ar" ? "rtl" : "ltr";

      await page.goto(`/?lang=${tag}`);
      await expect(page.getByRole("grid")).toBeVisible();
      const action = page.getByRole("combobox", { name: words.t("program.actionOf", { line: 2 }) });
      await page.getByRole("combobox", { name: words.t("shell.run.speed") }).selectOption("max");
      await action.selectOption("delayed left 90");
      await button("shell.run.run").click();
      await expect(card).toBeVisible();
      await look("bump", "[data-card]");
      // It lies on the stage, which never mirrors; its words do.
      await expect(card).toHaveCSS("direction", direction);
      await button("timeline.stepBack").click();
      await expect(button("timeline.backToNow")).toBeVisible();
      await look("past", "section[data-view]");
      await button("timeline.backToNow").click();
      await expect(card).toBeVisible();
      await card.getByRole("button").last().press("Escape");
      await action.selectOption("left 90");
      await button("shell.run.reset").click();
      await button("shell.run.run").click();
      await expect(card).toContainText(words.t("cards.solved.title"));
      await look("solved", "[data-card]");
      await card.getByRole("button").last().press("Escape");

      await page.getByRole("radio", { name: words.t("stage.tool.measure"), exact: true }).click();
      await page.getByRole("gridcell").first().focus();
      for (const key of ["Space", "ArrowRight", "ArrowDown", "Space"]) {
        await page.keyboard.press(key);
      }
      await look("measure");

      const menu = page.getByRole("button", { name: words.t("works.menu") });
      await menu.click();
      await look("maze menu");
      await button("files.savePicture").click();
      await expect(dialog).toBeVisible();
      await look("picture");
      await page.keyboard.press("Escape");
      await page.evaluate(
        (text) => navigator.clipboard.writeText(text),
        `{"format":"corridor/maze"}`,
      );
      await page.getByRole("banner").click({ position: { x: 2, y: 2 } });
      await page.keyboard.press("ControlOrMeta+V");
      await expect(dialog).toBeVisible();
      await look("file problems");
      await page.keyboard.press("Escape");

      if (isPhone) await button("shell.more").click();
      await page.getByRole("button", { name: words.t("lessons.lessons"), exact: true }).click();
      await expect(dialog).toBeVisible();
      await look("lessons");
      await dialog
        .getByRole("button")
        .filter({ hasText: words.t("missions.missions.farthest-distance.name") })
        .click();
      const mission = page.getByRole("region", {
        name: words.t("missions.card.label"),
        exact: true,
      });
      await expect(mission).toContainText(words.t("missions.missions.farthest-distance.task"));
      await mission.getByRole("button", { name: words.t("missions.card.hint") }).click();
      await look("mission");
      expect(faults).toEqual([]);
    });
  }
}

for (const { tag, dir } of [
  { tag: "en", dir: 1 },
  { tag: "ar", dir: -1 },
]) {
  test(`reads a comparison one way in ${tag}, and a minus before its figures`, async ({
    openWindow,
  }) => {
    const { page } = await openWindow();
    const words = Texts.load(tag);
    await page.goto(`/?lang=${tag}`);
    const [left, right] = ["left", "right"].map((side) => words.t(`program.sensor.${side}`));
    const condition = page.getByRole("combobox", {
      name: words.t("program.conditionOf", { line: 1 }),
    });
    await condition.selectOption({ label: `${left} > ${right} +` });
    const number = page.getByRole("textbox", { name: words.t("program.numberOf", { line: 1 }) });
    await number.fill("-20");

    const line = page.getByRole("listitem").filter({ has: number });
    // 50 cm on the left, 50 cm on the right: the condition compares 50 with 30.
    await expect(line).toContainText(/50\s*> 30/);
    const inOrder = async () => {
      const places = await line.evaluate((item) => {
        const middleOf = (rect: DOMRect): number => rect.left + rect.width / 2;
        const walker = document.createTreeWalker(item, NodeFilter.SHOW_TEXT);
        const found: { text: string; at: number }[] = [];
        for (let node = walker.nextNode(); node !== null; node = walker.nextNode()) {
          for (const { index, 0: text } of (node.textContent ?? "").matchAll(/[<>]|\d+/g)) {
            const range = document.createRange();
            range.setStart(node, index);
            range.setEnd(node, index + text.length);
            const rect = range.getBoundingClientRect();
            if (rect.width > 0) found.push({ text, at: middleOf(rect) });
          }
        }
        return found;
      });
      const truth = places.filter(({ text }) => ["50", ">", "30"].includes(text)).slice(-3);
      return truth.toSorted((one, other) => (one.at - other.at) * dir).map(({ text }) => text);
    };
    // Letters that are still on their way are wider.
    await expect.poll(inOrder).toEqual(["50", ">", "30"]);
    const [asked, given] = [await condition.boundingBox(), await number.boundingBox()];
    expect(((given?.x ?? 0) - (asked?.x ?? 0)) * dir).toBeGreaterThan(0);
    await expect(number).toHaveCSS("direction", "ltr");
  });
}
