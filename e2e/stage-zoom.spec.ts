/** Zooming the maze by button, key, wheel and two fingers. */
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { TouchInput } from "./support/touch-input.ts";
import { boxOf, phone } from "./support/phone.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

async function zoomsByButtonsKeysAndWheel(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { grid } = corridor.maze;
  const width = async () => (await boxOf(grid)).width;
  const initialWidth = await width();
  await page.getByRole("button", { name: "Zoom in" }).click();
  await expect.poll(width).toBeGreaterThan(initialWidth);
  await expect(page.locator("[data-map]")).toBeVisible();
  await page.getByRole("button", { name: "Fit the maze" }).click();
  await expect.poll(width).toBe(initialWidth);
  await expect(page.locator("[data-map]")).toBeHidden();

  await page.keyboard.press("+");
  await expect.poll(width).toBeGreaterThan(initialWidth);
  await page.keyboard.press("-");
  await expect.poll(width).toBe(initialWidth);

  const { x, y } = await boxOf(grid);
  await page.mouse.move(x + 10, y + 10);
  await page.keyboard.down("Control");
  // The gestures load when the pointer is first on the stage.
  await expect(async () => {
    await page.mouse.wheel(0, -300);
    expect(await width()).toBeGreaterThan(initialWidth);
  }).toPass();
  await page.keyboard.up("Control");
  await page.keyboard.press("0");
  await expect.poll(width).toBe(initialWidth);
}

async function ignoresZoomKeys(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.keyboard.press("?");
  const keys = page.getByRole("dialog").filter({ hasText: "Zoom in, zoom out, fit the maze" });
  await expect(keys).toBeVisible();
  await keys.getByRole("checkbox").first().uncheck();
  await page.keyboard.press("Escape");
  const before = (await boxOf(corridor.maze.grid)).width;
  await page.keyboard.press("+");
  await corridor.waitForFrames(12);
  expect((await boxOf(corridor.maze.grid)).width).toBe(before);
}

test("zooms with two fingers on a phone, and edits nothing", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { grid } = corridor.maze;
  const { x, y, width, height } = await boxOf(grid);
  const [centreX, centreY] = [x + width / 2, y + height / 2];
  const touch = await TouchInput.of(corridor.page);
  const at = (distance: number) =>
    [
      { x: centreX - distance, y: centreY },
      { x: centreX + distance, y: centreY },
    ] as const;
  // The gestures load when a finger is first on the stage.
  await expect(async () => {
    await touch.down(...at(30));
    for (const distance of [40, 55, 70, 90]) await touch.move(...at(distance));
    await touch.lift();
    expect((await boxOf(grid)).width).toBeGreaterThan(width * 1.5);
  }).toPass();
  await expect(corridor.maze.button("Undo")).toBeDisabled();
});

async function leavesZoomButtonsUncovered(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const zoom = page.getByRole("group", { name: "Zoom", exact: true });
  await expect(zoom).toBeVisible();
  await corridor.transport.getByRole("button", { name: "Write my own" }).click();
  await expect(corridor.messages).toContainText("Undo");
  const message = await boxOf(corridor.messages.getByText(/program is empty/i));
  const buttons = await boxOf(zoom);
  expect(message.y + message.height).toBeLessThanOrEqual(buttons.y);
  await page.getByRole("button", { name: "Zoom in" }).click({ timeout: 1000 });
}

test("zooms the maze with mouse and keyboard", async ({ corridor }) => {
  const step = (title: string, check: (page: CorridorPage) => Promise<void>) =>
    test.step(title, async () => {
      await check(corridor);
      await corridor.dismissMessages();
      await corridor.page.keyboard.press("0");
    });
  await step("does not cover the zoom buttons with messages", leavesZoomButtonsUncovered);
  await step(
    "zooms by buttons, keys and the wheel, and fits the maze again",
    zoomsByButtonsKeysAndWheel,
  );
  await step("ignores the zoom keys where single keys are off, and lists them", ignoresZoomKeys);
});
