/**
 * Layout: controls are not covered, not pushed out of their row, and not moved.
 */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { chooseLanguage } from "./support/choose-language.ts";
import { clearStorageOnLoad } from "./support/clear-storage.ts";
import { Texts } from "./support/texts.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

async function boxOf(part: Locator): Promise<DOMRect> {
  return part.evaluate((element) => {
    // If a box is wider than its text, measure the text.
    const range = document.createRange();
    range.selectNodeContents(element);
    return (element instanceof SVGElement ? element : range).getBoundingClientRect().toJSON();
  });
}

const desktops = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
] as const;

/** Compares in English, German, French and Arabic. Ends in English. */
async function placesTextsInEachLanguage({ page }: CorridorPage): Promise<void> {
  let shown = Texts.load("en");
  for (const { lang, inOneRow } of [
    { lang: "en", inOneRow: desktops },
    // A narrow line in German has two rows.
    { lang: "de", inOneRow: desktops.slice(0, 1) },
    { lang: "fr", inOneRow: [] },
    { lang: "ar", inOneRow: desktops },
  ]) {
    const texts = Texts.load(lang);
    const button = (path: string): Locator =>
      page.getByRole("button", { name: texts.t(path), exact: true });
    if (lang !== "en") await chooseLanguage(page, shown, lang);
    shown = texts;
    for (const size of inOneRow) {
      await page.setViewportSize(size);
      await expectComparisonsInOneRow(page, `${lang}, ${size.width} px`);
    }
    await page.getByRole("combobox", { name: texts.t("shell.run.speed") }).selectOption("max");
    await button("shell.run.step").click();
    await button("timeline.stepBack").waitFor();
    const slider = page.getByRole("slider", { name: texts.t("timeline.name") });
    await slider.press("Home");
    await expect(button("timeline.backToNow")).toBeVisible();
    for (const size of desktops.toReversed()) {
      await page.setViewportSize(size);
      await waitForAnimations(page);
      const state = `${lang}, ${size.width} px`;
      const pastBar = page.getByRole("group", { name: texts.t("timeline.pastNote") });
      const bar = await pastBar.evaluate((element) => element.getBoundingClientRect().toJSON());
      const scale = await boxOf(page.locator("main svg:has(text)", { hasText: /00/ }));
      // "Robot at {{x}}, {{y}}", up to the first number.
      const [robotAt = ""] = texts.t("stage.robotAt", { x: "|" }).split(/[\u2068|]/);
      const pose = await boxOf(page.locator("main").getByText(robotAt));
      expect(scale.right, state).toBeLessThan(bar.left);
      expect(bar.right, state).toBeLessThan(pose.left);
      // The pose is beside the button that describes the robot, in either text direction.
      const describe = await button("speech.describe.button").boundingBox();
      expect(Math.abs((describe?.x ?? 0) - pose.right), state).toBeLessThan(16);
    }
    await button("shell.run.reset").click();
    await button("timeline.stepBack").waitFor({ state: "detached" });
  }
  await chooseLanguage(page, shown, "en");
}

/** The two lines of the first program compare a sensor with a number. */
async function expectComparisonsInOneRow(page: Page, state: string): Promise<void> {
  for (const line of [0, 1]) {
    const sides = page.getByRole("list").getByRole("listitem").nth(line).locator("[data-is]");
    await expect(sides).toHaveAttribute("data-is", "false");
    const tops = await sides.evaluate((truth) => {
      const texts = document.createTreeWalker(truth, NodeFilter.SHOW_TEXT);
      const found: number[] = [];
      for (let node = texts.nextNode(); node !== null; node = texts.nextNode()) {
        const range = document.createRange();
        range.selectNodeContents(node);
        if (/\d/.test(node.textContent ?? "")) found.push(range.getBoundingClientRect().top);
      }
      return found;
    });
    expect(tops, state).toHaveLength(2);
    expect(Math.abs((tops[0] ?? 0) - (tops[1] ?? 9)), state).toBeLessThan(2);
  }
}

test("does not shift the panel while the page opens, also if its simulator loads late", async ({
  openWindow,
}) => {
  const { page } = await openWindow();
  await clearStorageOnLoad(page);
  let delay = 0;
  await page.route(/simulator\.worker/, async (route) => {
    await new Promise((resolve) => setTimeout(resolve, delay));
    await route.continue();
  });
  await page.addInitScript(() => {
    const moved: string[] = [];
    Reflect.set(window, "moved", moved);
    new PerformanceObserver((list) => {
      for (const entry of list.getEntries()) {
        const sources: unknown = Reflect.get(entry, "sources");
        if (!Array.isArray(sources)) continue;
        for (const { node } of sources as { node: Node | null }[]) {
          if (node instanceof Element && node.closest("aside")) moved.push(node.outerHTML);
        }
      }
    }).observe({ type: "layout-shift", buffered: true });
  });
  for (const size of desktops) {
    for (const milliseconds of [0, 700]) {
      delay = milliseconds;
      await page.setViewportSize(size);
      await page.goto("/");
      await page.getByRole("combobox", { name: "Line 2, action" }).waitFor();
      await page.getByRole("button", { name: "Add line" }).waitFor();
      await page.getByText("> 60", { exact: true }).waitFor();
      await page.evaluate(
        () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))),
      );
      const moved = await page.evaluate(() => Reflect.get(window, "moved"));
      expect(moved, `${size.width} px, ${milliseconds} ms late`).toEqual([]);
    }
  }
});

async function showsWholeAdvice(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await program.action(2).focus();
  await program.action(2).selectOption("delayed left 90");
  const fix = program.button("Change to left 90");
  await expect(fix).toBeInViewport({ ratio: 1 });
  await expect(program.action(2)).toBeInViewport({ ratio: 1 });
  await expect(program.action(2)).toBeFocused();
}

async function showsBumpBelowLine(corridor: CorridorPage): Promise<void> {
  const { program } = corridor;
  await expect(program.button("Change to left 90")).toBeVisible();
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.bumpCard(2)).toBeVisible();
  await expect(program.line(2).getByText(/^bumped after \d+ of 50 cm$/)).toBeInViewport({
    ratio: 1,
  });
}

async function keepsStepInPlace(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const stepPosition = async () => {
    const box = await corridor.step.boundingBox();
    return [box?.x, box?.width];
  };
  for (const size of [
    ...desktops,
    { width: 760, height: 900 },
    { width: 390, height: 844 },
    { width: 320, height: 640 },
  ]) {
    const state = `${size.width} px`;
    await page.setViewportSize(size);
    // A first visit also has the button for a program of one's own in this row.
    await corridor.transport.getByRole("button", { name: "Write my own" }).waitFor();
    await waitForAnimations(page);
    const before = await stepPosition();
    const { x = 0, y = 0 } = (await corridor.step.boundingBox()) ?? {};
    await page.mouse.click(x + 4, y + 12);
    await corridor.timeline.previousDecision.waitFor();
    await page.mouse.move(0, 0);
    expect(await stepPosition(), state).toEqual(before);
    await corridor.run.click();
    await corridor.timeline.previousDecision.waitFor({ state: "hidden" });
    expect(await stepPosition(), state).toEqual(before);
    await corridor.reset.click();
    await corridor.run.waitFor();
    await expect(corridor.clock).toHaveText("Time 0:00.0");
  }
}

test("shows the controls and texts of a program in their places at each size, in English, German, French and Arabic", async ({
  corridor,
  page,
}) => {
  await test.step("keeps Step under the pointer at each size, so that it can be pressed repeatedly", () =>
    keepsStepInPlace(corridor));
  await page.setViewportSize(desktops[0]);
  await test.step("shows comparisons in one row, and does not cover scale and robot pose with the past bar", () =>
    placesTextsInEachLanguage(corridor));
  await page.setViewportSize(desktops[1]);
  await test.step("shows the whole advice below an edited line in a scrolled list", () =>
    showsWholeAdvice(corridor));
  await test.step("shows the bump on a line whose hidden advice leaves room below it", () =>
    showsBumpBelowLine(corridor));
});

test("shows run, steps, reset and speed in one row on phones, in English, German and Arabic", async ({
  openWindow,
}) => {
  const sizes = [
    { width: 390, height: 700 },
    { width: 320, height: 700 },
  ];
  const { page } = await openWindow({ hasTouch: true, isMobile: true });
  await page.goto("/");
  let shown = Texts.load("en");
  for (const lang of ["en", "de", "ar"]) {
    const texts = Texts.load(lang);
    const button = (path: string): Locator =>
      page.getByRole("button", { name: texts.t(path), exact: true });
    const speed = page.getByRole("combobox", { name: texts.t("shell.run.speed") });
    /** The largest difference between the tops. A pressed button moves down by a pixel. */
    const topDifference = async (...parts: Locator[]) => {
      const tops = await Promise.all(parts.map(async (part) => (await part.boundingBox())?.y ?? 0));
      return Math.max(...tops) - Math.min(...tops);
    };
    const atEachSize = async (check: (state: string) => Promise<void>): Promise<void> => {
      for (const size of sizes) {
        await page.setViewportSize(size);
        await waitForAnimations(page);
        await check(`${lang}, ${size.width} px`);
      }
    };
    const [step, back] = [button("shell.run.step"), button("timeline.stepBack")];
    // On the first visit the row includes "Write my own", whose label has at most two lines.
    const own = button("program.writeOwn");
    if (lang !== "en") await chooseLanguage(page, shown, lang);
    shown = texts;
    await own.waitFor();
    await atEachSize(async (state) => {
      const difference = await topDifference(button("shell.run.run"), own, step, speed);
      expect(difference, state).toBeLessThan(4);
      expect((await own.boundingBox())?.height, state).toBeLessThan(46);
    });
    await speed.selectOption("0.25");
    await button("shell.run.run").tap();
    const pause = button("shell.run.pause");
    await pause.waitFor();
    // The text has two lines beside the button, or one line of its own.
    const invitation = page.getByText(texts.t("lessons.invitation"));
    // The page replaces the elements of the first paint with its own.
    const height = async () => (await invitation.boundingBox())?.height ?? Number.NaN;
    await atEachSize(async (state) => {
      await expect.poll(height, { message: state }).toBeLessThan(40);
      expect(await topDifference(pause, step, speed), state).toBeLessThan(4);
    });
    await pause.tap();
    await speed.selectOption("max");
    await back.waitFor();
    await atEachSize(async (state) => {
      const difference = await topDifference(button("shell.run.run"), back, step, speed);
      expect(difference, state).toBeLessThan(4);
    });
    await speed.selectOption("1");
    await button("shell.run.reset").tap();
  }
});
