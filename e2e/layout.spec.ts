/**
 * Layout: controls are not covered, not pushed out of their row, and not moved.
 */
import type { Locator } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { Texts } from "./support/texts.ts";

async function boxOf(part: Locator): Promise<DOMRect> {
  return part.evaluate((element) => {
    // If a box is wider than its text, measure the text.
    const range = document.createRange();
    range.selectNodeContents(element);
    return (element instanceof SVGElement ? element : range).getBoundingClientRect().toJSON();
  });
}

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
] as const) {
  for (const lang of ["en", "de", "fr", "ar"]) {
    test(`does not cover scale and robot pose with the past bar at ${width} x ${height}, in ${lang}`, async ({
      openWindow,
    }) => {
      const { page } = await openWindow({ viewport: { width, height } });
      const texts = Texts.load(lang);
      const button = (path: string): Locator =>
        page.getByRole("button", { name: texts.t(path), exact: true });
      await page.goto(`/?lang=${lang}`);
      await button("shell.run.run").click();
      const slider = page.getByRole("slider", { name: texts.t("timeline.name") });
      await expect(page.locator("section[data-view]")).not.toContainText(/0:00[.,]0/);
      await button("shell.run.pause").click();
      await slider.press("ArrowLeft");
      await expect(button("timeline.backToNow")).toBeVisible();
      const pastBar = page.getByRole("group", { name: texts.t("timeline.pastNote") });
      const bar = await pastBar.evaluate((element) => element.getBoundingClientRect().toJSON());
      const scale = await boxOf(page.locator("main svg:has(text)", { hasText: /00/ }));
      // "Robot at {{x}}, {{y}}", up to the first number.
      const [robotAt = ""] = texts.t("stage.robotAt", { x: "|" }).split(/[\u2068|]/);
      const pose = await boxOf(page.locator("main").getByText(robotAt));
      expect(scale.right).toBeLessThan(bar.left);
      expect(bar.right).toBeLessThan(pose.left);
      // The pose is beside the button that describes the robot, in either text direction.
      const describe = await button("speech.describe.button").boundingBox();
      expect(Math.abs((describe?.x ?? 0) - pose.right)).toBeLessThan(16);
    });
  }

  for (const [delay, milliseconds] of [
    ["without delay", 0],
    ["700 ms late", 700],
  ] as const) {
    test(`does not shift the panel while the page opens at ${width} x ${height} and its simulator loads ${delay}`, async ({
      openWindow,
    }) => {
      const { page } = await openWindow({ viewport: { width, height } });
      await page.route(/simulator\.worker/, async (route) => {
        await new Promise((resolve) => setTimeout(resolve, milliseconds));
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
      await page.goto("/");
      await expect(page.getByRole("combobox", { name: "Line 2, action" })).toBeVisible();
      await expect(page.getByRole("button", { name: "Add line" })).toBeVisible();
      await expect(page.getByText("> 60", { exact: true })).toBeVisible();
      await page.evaluate(
        () => new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve))),
      );
      expect(await page.evaluate(() => Reflect.get(window, "moved"))).toEqual([]);
    });
  }
}

test("shows the whole advice below an edited line in a scrolled list", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 1024, height: 768 } });
  await corridor.open();
  const { program } = corridor;
  await program.action(2).focus();
  await program.action(2).selectOption("delayed left 90");
  const fix = program.button("Change to left 90");
  await expect(fix).toBeInViewport({ ratio: 1 });
  await expect(program.action(2)).toBeInViewport({ ratio: 1 });
  await expect(program.action(2)).toBeFocused();
});

test("shows the bump on a line whose hidden advice leaves room below it", async ({
  openWindow,
}) => {
  const corridor = await openWindow({ viewport: { width: 1024, height: 768 } });
  await corridor.open();
  const { program } = corridor;
  await program.action(2).selectOption("delayed left 90");
  await expect(program.button("Change to left 90")).toBeVisible();
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.bumpCard(2)).toBeVisible();
  await expect(program.line(2).getByText(/^bumped after \d+ of 50 cm$/)).toBeInViewport({
    ratio: 1,
  });
});

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
  [760, 900],
  [390, 844],
  [320, 640],
] as const) {
  test(`keeps Step under the pointer at ${width} px, so that it can be pressed repeatedly`, async ({
    page,
  }) => {
    await page.setViewportSize({ width, height });
    const corridor = new CorridorPage(page);
    await corridor.open();
    const stepPosition = async () => {
      const box = await corridor.step.boundingBox();
      return [box?.x, box?.width];
    };
    const before = await stepPosition();
    const { x = 0, y = 0 } = (await corridor.step.boundingBox()) ?? {};
    await page.mouse.click(x + 4, y + 12);
    await expect(corridor.timeline.previousDecision).toBeVisible();
    await page.mouse.move(0, 0);
    expect(await stepPosition()).toEqual(before);
    await corridor.run.click();
    await expect(corridor.timeline.previousDecision).toBeHidden();
    expect(await stepPosition()).toEqual(before);
  });
}

for (const [width, height, lang] of [
  [1440, 900, "de"],
  [1024, 768, "en"],
  [1024, 768, "ar"],
] as const) {
  test(`shows a comparison in one row at ${width} x ${height}, in ${lang}`, async ({
    openWindow,
  }) => {
    const { page } = await openWindow({ viewport: { width, height } });
    await page.goto(`/?lang=${lang}`);
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
      expect(tops).toHaveLength(2);
      expect(Math.abs((tops[0] ?? 0) - (tops[1] ?? 9))).toBeLessThan(2);
    }
  });
}

for (const lang of ["en", "de", "ar"]) {
  for (const width of [390, 320]) {
    test(`shows run, steps, reset and speed in one row at ${width} px, in ${lang}`, async ({
      openWindow,
    }) => {
      const { page } = await openWindow({
        viewport: { width, height: 700 },
        hasTouch: true,
        isMobile: true,
      });
      const texts = Texts.load(lang);
      await page.goto(`/?lang=${lang}`);
      const button = (path: string): Locator =>
        page.getByRole("button", { name: texts.t(path), exact: true });
      const speed = page.getByRole("combobox", { name: texts.t("shell.run.speed") });
      /** The largest difference between the tops. A pressed button moves down by a pixel. */
      const topDifference = async (...parts: Locator[]) => {
        const tops = await Promise.all(
          parts.map(async (part) => (await part.boundingBox())?.y ?? 0),
        );
        return Math.max(...tops) - Math.min(...tops);
      };
      const [step, back] = [button("shell.run.step"), button("timeline.stepBack")];
      // On the first visit the row includes "Write my own", whose label has at most two lines.
      const own = button("program.writeOwn");
      await expect(own).toBeVisible();
      expect(await topDifference(button("shell.run.run"), own, step, speed)).toBeLessThan(4);
      expect((await own.boundingBox())?.height).toBeLessThan(46);
      await speed.selectOption("0.25");
      await button("shell.run.run").tap();
      const pause = button("shell.run.pause");
      await expect(pause).toBeVisible();
      // The text has two lines beside the button, or one line of its own.
      const invitation = page.getByText(texts.t("lessons.invitation"));
      // The page replaces the elements of the first paint with its own.
      const height = async () => (await invitation.boundingBox())?.height ?? Number.NaN;
      await expect.poll(height).toBeLessThan(40);
      expect(await topDifference(pause, step, speed)).toBeLessThan(4);
      await pause.tap();
      await speed.selectOption("max");
      await expect(back).toBeVisible();
      expect(await topDifference(button("shell.run.run"), back, step, speed)).toBeLessThan(4);
    });
  }
}
