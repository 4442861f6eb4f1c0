/**
 * High contrast: requested by the system or selected on the page, in both themes, and forced
 * colours.
 */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { StageScreenshot } from "./pages/stage-screenshot.ts";
import { axeViolations, onlyRule } from "./support/axe.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";

/** Texts with a contrast below 7:1, as axe measures them. */
async function lowContrastTexts(page: Page): Promise<string[]> {
  await waitForAnimations(page);
  const violations = await axeViolations(page, onlyRule("color-contrast-enhanced"));
  return violations.flatMap(({ nodes }) => nodes.map(({ target }) => target.join(" ")));
}

async function showsHighContrast(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const expectHighContrast = async (state: string): Promise<void> => {
    for (const colorScheme of ["light", "dark"] as const) {
      await page.emulateMedia({ contrast: "more", colorScheme, reducedMotion: "reduce" });
      await expect(page.locator("html")).toHaveAttribute("data-theme", colorScheme);
      await expect(page.locator("html")).toHaveAttribute("data-contrast", "more");
      expect(await lowContrastTexts(page), `${state}, ${colorScheme}`).toEqual([]);
    }
  };
  await corridor.step.click();
  await expect(corridor.run).toBeVisible();
  await expectHighContrast("program");
  await corridor.share.click();
  await expect(corridor.dialog("Share this maze")).toBeVisible();
  await expectHighContrast("share");
}

async function storesHighContrast(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const html = page.locator("html");
  await expect(html).toHaveAttribute("data-contrast", "normal");
  await page.getByRole("button", { name: "Theme", exact: true }).click();
  await page.getByRole("checkbox", { name: /^High contrast/ }).check();
  await expect(html).toHaveAttribute("data-contrast", "more");
  await corridor.reload();
  await expect(html).toHaveAttribute("data-contrast", "more");
}

async function showsFilledButtons(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.emulateMedia({ forcedColors: "active" });
  const colours = (element: Element): { text: string; background: string } => {
    const style = getComputedStyle(element);
    return { text: style.color, background: style.backgroundColor };
  };
  for (const button of [corridor.run, corridor.share]) {
    const { text, background } = await button.evaluate(colours);
    expect(text).not.toBe(background);
  }
  const around = (driver: "Program" | "Remote") => corridor.driver(driver).locator("xpath=..");
  const [chosen, other] = [around("Program"), around("Remote")];
  expect((await chosen.evaluate(colours)).background).not.toBe(
    (await other.evaluate(colours)).background,
  );
  await corridor.share.click();
  await expect(corridor.dialog("Share this maze")).toHaveCSS("border-top-style", "solid");
  await page.keyboard.press("Escape");
}

async function showsTouchingSensor(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.emulateMedia({ forcedColors: "active" });
  await corridor.program.action(2).selectOption("delayed left 90");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.bumpCard(2)).toBeVisible();
  const reading = corridor.sensor("front");
  await expect(reading).toHaveText("25");
  const [text, background] = await reading.evaluate((element) => {
    const { color, backgroundColor } = getComputedStyle(element);
    return [color, backgroundColor];
  });
  expect(text).not.toBe(background);
  // Otherwise the browser paints its own background, which has the colour of the number.
  await expect(reading).toHaveCSS("forced-color-adjust", "none");
}

async function paintsDarkMaze(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.maze.grid.waitFor();
  const stage = new StageScreenshot(page);
  await page.emulateMedia({ forcedColors: "active", colorScheme: "light" });
  const light = await stage.capture();
  await page.emulateMedia({ forcedColors: "active", colorScheme: "dark" });
  await stage.expectDifferent(light);
}

test("has high contrast when requested, and works in forced colours", async ({
  corridor,
  page,
}) => {
  const step = (title: string, check: (page: CorridorPage) => Promise<void>) =>
    test.step(title, async () => {
      await check(corridor);
      await page.emulateMedia({ forcedColors: null, colorScheme: null });
    });
  await step(
    "paints the maze on a dark background where the forced colours are dark",
    paintsDarkMaze,
  );
  await step(
    "shows the number of the sensor that touches a wall in forced colours",
    showsTouchingSensor,
  );
  await step(
    "shows filled buttons, the selected driver and the edge of a dialog in forced colours",
    showsFilledButtons,
  );
  await step("stores the choice of high contrast across a reload", storesHighContrast);
  await step(
    "shows every text at 7:1 in both themes when the system requests more contrast",
    showsHighContrast,
  );
});
