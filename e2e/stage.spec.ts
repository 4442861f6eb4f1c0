/**
 * Painting and measuring on the stage. Screenshots are compared with each other, never with files.
 */
import { expect, test } from "./fixtures.ts";
import { StageScreenshot } from "./pages/stage-screenshot.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

const text = (element: { textContent: () => Promise<string | null> }) => element.textContent();

test.describe("measuring", () => {
  test("draws a tape along a drag and announces its length without editing the maze", async ({
    corridor,
  }) => {
    const { maze } = corridor;
    const picture = new StageScreenshot(corridor.page);
    await maze.tool("Measure").click();
    const before = await picture.capture();
    await maze.drag([
      { column: 0, row: 4 },
      { column: 2, row: 4 },
      { column: 3, row: 4 },
    ]);
    await expect(maze.announcement).toHaveText("300 cm, 3 squares.");
    await picture.expectDifferent(before);
    await maze.expectSquare({ column: 2, row: 4 }, "open");
    await expect(maze.button("Undo")).toBeDisabled();
    await corridor.page.keyboard.press("Escape");
    await expect(maze.announcement).not.toContainText("squares");
  });

  test("measures by keyboard from one square to another", async ({ corridor }) => {
    const { maze, page } = corridor;
    await maze.tool("Measure").click();
    await maze.moveCursorTo({ column: 1, row: 6 });
    await page.keyboard.press("Enter");
    await expect(maze.announcement).toContainText("Measuring from row 7, column 2");
    await maze.moveCursorTo({ column: 4, row: 2 });
    await page.keyboard.press("Space");
    await expect(maze.announcement).toHaveText("500 cm, 5 squares. 300 cm across, 400 cm up.");
    await expect(maze.button("Undo")).toBeDisabled();
  });
});

test("enters and leaves full screen", async ({ corridor }) => {
  const { page } = corridor;
  const isFull = () => page.evaluate(() => document.fullscreenElement !== null);
  await corridor.maze.button("Full screen").click();
  await expect.poll(isFull).toBe(true);
  await corridor.maze.button("Leave full screen").click();
  await expect.poll(isFull).toBe(false);
  await expect(corridor.maze.button("Full screen")).toBeVisible();
});

test("draws the path of a delayed turn ahead of the robot", async ({ corridor }) => {
  const picture = new StageScreenshot(corridor.page);
  // A slow machine must see the first turn before the robot has passed it.
  await corridor.speed.selectOption("0.25×");
  await corridor.run.click();
  await expect(corridor.robotPose).toHaveText(/facing up/);
  const running = corridor.page.locator("li[aria-current=step]");
  await expect(running).toContainText(/turns in \d+ cm/);
  await corridor.pause.click();
  await expect(corridor.run).toBeVisible();
  const remaining = Number(/turns in (\d+)/.exec((await text(running)) ?? "")?.[1]);
  const pose = /Robot at (\d+), (\d+), facing up/.exec((await text(corridor.robotPose)) ?? "");
  const x = Number(pose?.[1]);
  const y = Number(pose?.[2]) - remaining;
  // Beyond the junction, to the right of the turning point, where nothing else is drawn.
  const path = { x: x + 30, y: y - 8, width: 60, height: 16 };
  const dashes = await picture.differingPixels(path, {
    x: x + 30,
    y: y - 30,
    width: 60,
    height: 16,
  });
  expect(remaining).toBeGreaterThan(0);
  expect(dashes).toBeGreaterThan(20);
});

test.describe("repaints the stage", () => {
  test("in the colours of another theme", async ({ corridor }) => {
    const picture = new StageScreenshot(corridor.page);
    const light = await picture.capture();
    await corridor.page.emulateMedia({ colorScheme: "dark" });
    await picture.expectDifferent(light);
    const dark = await picture.capture();
    await corridor.page.emulateMedia({ colorScheme: "light" });
    await picture.expectDifferent(dark);
    await picture.expectSame(light);
  });

  test("where the browser cannot transfer canvases to a worker", async ({ page, corridor }) => {
    const inWorker = await new StageScreenshot(page).capture();
    await page.addInitScript(() => Reflect.deleteProperty(window, "OffscreenCanvas"));
    await corridor.reload();
    await new StageScreenshot(page).expectSame(inWorker);
    const canDraw = () =>
      page
        .locator("canvas")
        .first()
        .evaluate((canvas: HTMLCanvasElement) => canvas.getContext("2d") !== null);
    expect(await canDraw()).toBe(true);
    await corridor.run.click();
    await expect.poll(() => corridor.robotX()).toBeGreaterThan(80);
    await new StageScreenshot(page).expectDifferent(inWorker);
  });
});
