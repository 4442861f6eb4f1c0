/** Large letters, a page zoomed to 400 %, and the system's own colours: everything is there and can be used. */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { stickingOut } from "./support/layout.ts";

/** As a reader does in the browser's settings: everything in rem is twice as large. */
async function doubleLetters(page: Page): Promise<void> {
  await page.evaluate(() => document.documentElement.style.setProperty("font-size", "200%"));
}

for (const [width, height] of [
  [1440, 900],
  [390, 844],
] as const) {
  test(`reads everything in letters of 200 % at ${width} x ${height}`, async ({ openWindow }) => {
    const corridor = await openWindow({ viewport: { width, height } });
    await corridor.open();
    const { page } = corridor;
    await doubleLetters(page);
    expect(await stickingOut(page), "first visit").toEqual([]);
    await page.keyboard.press("?");
    await expect(corridor.dialog("Keyboard shortcuts")).toBeVisible();
    expect(await stickingOut(page), "keys").toEqual([]);
    await page.keyboard.press("Escape");
    await corridor.run.click();
    await expect(corridor.pause).toBeVisible();
    await corridor.pause.click();
    expect(await stickingOut(page), "after a run").toEqual([]);
    await corridor.run.scrollIntoViewIfNeeded();
    await expect(corridor.run).toBeInViewport();
    await corridor.program.line(1).scrollIntoViewIfNeeded();
    await expect(corridor.program.line(1)).toBeInViewport();
  });
}

test("works at 400 %: a window of 1280 x 1024 has 320 x 256 px then", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 320, height: 256 } });
  await corridor.open();
  const { page } = corridor;
  expect(await stickingOut(page), "first visit").toEqual([]);
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

test("shows focus, choice and state in forced colours", async ({ corridor, page }) => {
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
  const card = page.getByRole("region", { name: /^Bump: line 2/ });
  await expect(card).toBeVisible();
  // What is a surface without colours has an edge.
  const edges = await card.evaluate((element) => {
    const { borderTopWidth, borderTopStyle, outlineStyle } = getComputedStyle(element);
    return Number.parseFloat(borderTopWidth) > 0 && borderTopStyle !== "none"
      ? "border"
      : outlineStyle;
  });
  expect(edges).not.toBe("none");
});
