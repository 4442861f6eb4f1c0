/**
 * The phone layout's bottom sheet and its surroundings: sheet states, presets, messages and
 * painting.
 */
import { expect, test } from "./fixtures.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { StageScreenshot } from "./pages/stage-screenshot.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { TouchInput, centreOf } from "./support/touch-input.ts";
import { boxOf, phone, smallestPhone, tab } from "./support/phone.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

test("drags the sheet, shows messages without blocking the maze, paints and selects a preset", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page, program, maze } = corridor;
  const touch = await TouchInput.of(page);

  await test.step("does not scroll the page in any tab", async () => {
    for (const name of ["Presets", "Drive", "Program"] as const) {
      await tab(page, name).tap();
      await waitForAnimations(page);
      // The sheet scrolls its own overflow. The page itself must not scroll.
      const below = await page.evaluate(() => document.documentElement.scrollHeight - innerHeight);
      expect(below, name).toBe(0);
    }
  });

  await test.step("paints blocks with one finger, and nothing with two", async () => {
    const box = await boxOf(maze.grid);
    const side = box.width / 11;
    const at = (column: number, row: number) => ({
      x: box.x + (column + 0.5) * side,
      y: box.y + (row + 0.5) * side,
    });
    await touch.drag(at(6, 1), at(8, 1));
    for (const column of [6, 7, 8]) await maze.expectSquare({ column, row: 1 }, "block");
    await touch.down(at(0, 0), at(2, 0));
    await touch.move(at(1, 0), at(1, 0));
    await touch.lift();
    for (const column of [0, 1, 2]) await maze.expectSquare({ column, row: 0 }, "open");
  });

  await test.step("shows a long message without covering the maze", async () => {
    await page.keyboard.press("i");
    const dismiss = corridor.messages.getByRole("button", { name: "Dismiss" });
    await expect(dismiss).toBeVisible();
    await waitForAnimations(page);
    // It stays, so it takes its room from the stage.
    const box = await boxOf(dismiss.locator(".."));
    const grid = await boxOf(maze.grid);
    expect(box.y).toBeGreaterThanOrEqual(grid.y + grid.height);
    await corridor.dismissMessages();
  });

  for (const viewport of [phone.viewport, { width: 320, height: 640 }]) {
    await test.step(`shows a message over the bar without blocking tools, lines and maze at ${viewport.width} px`, async () => {
      await page.setViewportSize(viewport);
      await waitForAnimations(page);
      await page.getByRole("button", { name: "Move or delete line 2" }).tap();
      await corridor.dialog("Move or delete line 2").getByRole("button", { name: "Delete" }).tap();
      await expect(corridor.message("Line 2 deleted.")).toBeVisible();
      await waitForAnimations(page);
      const box = await boxOf(corridor.message("Line 2 deleted.").locator(".."));
      const tools = page.getByRole("group", { name: "Tool" });
      expect(box.y + box.height).toBeLessThanOrEqual((await boxOf(tools)).y);
      await page.getByRole("radio", { name: "Goal" }).tap();
      await expect(page.getByRole("radio", { name: "Goal" })).toBeChecked();
      await corridor.messages.getByRole("button", { name: "Undo" }).tap();
      await expect(program.lines).toHaveCount(2);
      await page.getByRole("radio", { name: "Blocks" }).tap();
    });
  }

  for (const { viewport } of [smallestPhone, phone]) {
    await test.step(`drags the sheet open and closed at ${viewport.width} x ${viewport.height}`, async () => {
      await page.setViewportSize(viewport);
      await waitForAnimations(page);
      const bar = page.getByRole("button", { name: /^Panel is / });
      const dragBar = async (by: number) => {
        const from = await centreOf(bar);
        await touch.drag(from, { x: from.x, y: from.y + by });
        // The sheet must finish its animation before the next touch can hit its content.
        await corridor.waitForFrames(30);
      };
      // While the sheet is half open, the whole maze is visible.
      await expect(bar).toHaveAccessibleName("Panel is half open. Open it fully");
      const grid = await boxOf(maze.grid);
      expect(grid.y + grid.height).toBeLessThanOrEqual((await boxOf(corridor.transport)).y);
      const panel = await boxOf(page.getByRole("tabpanel"));
      await dragBar(-60);
      await expect(bar).toHaveAccessibleName("Panel is open. Close it");
      await expect
        .poll(async () => (await boxOf(page.getByRole("tabpanel"))).height)
        .toBeGreaterThan(panel.height);
      await dragBar(60);
      await expect(bar).toHaveAccessibleName("Panel is half open. Open it fully");
      await dragBar(60);
      await expect(bar).toHaveAccessibleName("Panel is closed. Open it halfway");
      await expect(program.button("Add line")).toBeHidden();
      await bar.click();
      await expect(program.button("Add line")).toBeVisible();
      // A tab of a closed sheet opens it. A tap on the bar moves the sheet from half to open to
      // closed.
      await bar.click();
      await expect(bar).toHaveAccessibleName("Panel is open. Close it");
      await bar.click();
      await expect(bar).toHaveAccessibleName("Panel is closed. Open it halfway");
      await tab(page, "Drive").click();
      await expect(corridor.driveKey("forward")).toBeVisible();
      await tab(page, "Program").click();
    });
  }

  await test.step("selects a preset", async () => {
    await tab(page, "Presets").tap();
    const cards = page.getByRole("list", { name: "Presets" }).getByRole("button");
    const [first, second, third] = await Promise.all([0, 1, 2].map((at) => boxOf(cards.nth(at))));
    // The cards have two columns.
    expect(second?.y).toBe(first?.y);
    expect(third?.x).toBe(first?.x);
    expect(third?.y).toBeGreaterThan((first?.y ?? 0) + (first?.height ?? 0));
    const spiral = page.getByRole("button", { name: "Spiral right turns only" });
    await spiral.tap();
    await expect(spiral).toHaveAttribute("aria-current", "true");
    await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  });
});

test("does not cover the flag of mission 3, and shows the verdict on a failed mission once", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  const lessons = new LessonsPanel(page);

  await test.step("does not cover the flag with the reading of the beam that ends at it", async () => {
    await lessons.openMissionOnPhone(3);
    const stage = new StageScreenshot(page);
    await stage.capture();
    // Left of the flag, above the beam and at the top of the goal's square: all in the goal's green.
    const size = { width: 14, height: 8 };
    const nearBeam = { x: 112, y: 132, ...size };
    const onTop = { x: 112, y: 110, ...size };
    await expect.poll(() => stage.differingPixels(nearBeam, onTop)).toBe(0);
    const block = { ...nearBeam, y: 30 };
    expect(await stage.differingPixels(block, onTop), "a block").toBeGreaterThan(0);
  });

  await test.step("shows the verdict once, and with the task after its card is closed", async () => {
    await lessons.openMissionOnPhone(6);
    await corridor.speed.selectOption("max");
    await corridor.run.tap();
    const card = page.getByRole("region", { name: "Bump", exact: true });
    await expect(card).toContainText("A line for this place is missing.");
    // The sentence below the task is there only for screen readers.
    await expect(lessons.outcome).toContainText("A line for this place is missing.");
    const height = async () => (await boxOf(lessons.outcome)).height;
    expect(await height()).toBeLessThan(2);
    await expect(corridor.program.otherwise).toBeInViewport();
    await card.getByRole("button", { name: "Close" }).tap();
    await expect(card).toBeHidden();
    expect(await height()).toBeGreaterThan(16);
  });
});

test("keeps dialogs and tabs open when a phone is rotated, shows the end of a menu, and leaves the maze space", async ({
  openWindow,
}) => {
  const corridor = await openWindow({ ...phone, viewport: { width: 844, height: 390 } });
  await corridor.open();
  const { page } = corridor;
  const toPortrait = () => page.setViewportSize(phone.viewport);
  const toLandscape = () => page.setViewportSize({ width: 844, height: 390 });

  await test.step("keeps dialogs and tabs open", async () => {
    await corridor.program.button("Try it in other mazes").click();
    const mazes = corridor.dialog("Try it in other mazes");
    await expect(mazes).toBeVisible();
    await toPortrait();
    await expect(mazes).toBeVisible();
    await toLandscape();
    await expect(mazes).toBeVisible();
    await mazes.getByRole("button", { name: "Close" }).click();
    await expect(mazes).toBeHidden();

    // The presets move to their tab, and the selected tab survives a rotation.
    await page.getByRole("button", { name: "Presets", exact: true }).click();
    await expect(corridor.dialog("Presets")).toBeVisible();
    await toPortrait();
    await expect(tab(page, "Presets")).toHaveAttribute("aria-selected", "true");
    await expect(page.getByRole("button", { name: /^Spiral/ })).toBeVisible();
    await tab(page, "Drive").click();
    await toLandscape();
    await toPortrait();
    await expect(tab(page, "Drive")).toHaveAttribute("aria-selected", "true");
    await tab(page, "Program").click();
  });

  for (const viewport of [
    { width: 844, height: 390 },
    { width: 320, height: 640 },
  ]) {
    await test.step(`shows the end of a menu at ${viewport.width} x ${viewport.height}, and after a rotation`, async () => {
      await page.setViewportSize(viewport);
      await waitForAnimations(page);
      await page.getByRole("button", { name: "View" }).click();
      const menu = corridor.dialog("View");
      const isVisible = async (height: number) => {
        const box = await boxOf(menu);
        return box.y >= 0 && box.y + box.height <= height;
      };
      await expect.poll(() => isVisible(viewport.height)).toBe(true);
      await page.setViewportSize({ width: viewport.height, height: viewport.width });
      await expect.poll(() => isVisible(viewport.width)).toBe(true);
      await page.keyboard.press("Escape");
      await expect(menu).toBeHidden();
    });
  }

  await test.step("leaves the maze enough space above a card at 320 x 640", async () => {
    await page.setViewportSize({ width: 320, height: 640 });
    await corridor.program.number(2).fill("20");
    await corridor.speed.selectOption("max");
    await corridor.run.click();
    await expect(corridor.bumpCard(2)).toBeVisible();
    await waitForAnimations(page);
    const maze = await boxOf(corridor.maze.grid);
    expect(maze.height).toBeGreaterThan(75);
    expect(maze.y + maze.height).toBeLessThanOrEqual((await boxOf(corridor.transport)).y);
  });
});
