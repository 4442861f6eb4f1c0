/**
 * Drives on a phone with a thumb: the stage goes along, and the missions of the hand are done so.
 */
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { TouchInput, centreOf } from "./support/touch-input.ts";
import { unreadableTexts } from "./support/layout.ts";
import { boxOf, phone, tab } from "./support/phone.ts";

/** Pixels per cm while the stage goes with the robot. */
const SCALE = 0.6;

/** The whole maze in small; a picture, so it has no role. */
function smallMap(page: Page): Locator {
  return page.locator("[data-map]");
}

/** Chooses a maze in the tab of the presets. */
async function choose(corridor: CorridorPage, title: string): Promise<void> {
  await tab(corridor.page, "Presets").tap();
  await corridor.page.getByRole("button", { name: new RegExp(`^${title}`) }).tap();
  await expect(corridor.mazeMenu).toHaveAccessibleName(`${title}, Maze menu`);
}

test("drives on a phone and sees the robot followed with a small map", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await choose(corridor, "Empty");
  await tab(page, "Drive").tap();
  await expect(corridor.transport).toBeHidden();
  await expect(smallMap(page)).toBeVisible();
  // The sheet grows for the keys, and the map goes with it.
  await waitForAnimations(page);
  const columns = Number(await corridor.maze.grid.getAttribute("aria-colcount"));
  expect((await boxOf(corridor.maze.grid)).width).toBeCloseTo(columns * 100 * SCALE, 0);
  const before = { maze: await boxOf(corridor.maze.grid), dot: await robotOnMap(page) };

  const fingers = await TouchInput.of(page);
  await fingers.down(await centreOf(corridor.driveKey("forward")));
  await expect(page.getByText("You are driving.")).toBeVisible();
  await expect.poll(async () => (await boxOf(corridor.maze.grid)).x).toBeLessThan(before.maze.x);
  await fingers.lift();
  await corridor.waitForRobotToStop();

  // The stage has gone so far that the robot is in its middle.
  const maze = await boxOf(corridor.maze.grid);
  expect(maze.x + (await corridor.robotX()) * SCALE).toBeCloseTo(phone.viewport.width / 2, -1);
  const dot = await robotOnMap(page);
  expect(dot.x).toBeGreaterThan(before.dot.x);
  expect(dot.y).toBeCloseTo(before.dot.y, 0);
});

/** The robot's place on the small map, from its corner. */
async function robotOnMap(page: Page) {
  const map = await boxOf(smallMap(page));
  const { x, y } = await centreOf(smallMap(page).locator("svg").last());
  return { x: x - map.x, y: y - map.y };
}

test("does the missions of the hand with a thumb, and every button is there whole", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  const next = page.getByRole("button", { name: "Next mission" });
  const runProgram = page.getByRole("button", { name: "Run program" });
  await page.getByRole("button", { name: "Start with mission 1" }).tap();
  await expect(corridor.driveKey("forward")).toBeVisible();
  await waitForAnimations(page);
  await expect(runProgram).toBeInViewport({ ratio: 1 });
  expect(await unreadableTexts(page), "mission 1").toEqual([]);
  // There is no keyboard whose keys could be held.
  await expect(page.getByRole("region", { name: "Mission" })).toHaveText(
    "Hold the forward key until the robot stands on the green goal.",
  );
  const fingers = await TouchInput.of(page);
  await fingers.down(await centreOf(corridor.driveKey("forward")));
  await expect(page.getByRole("note")).toHaveText(/^Challenge solved after/);
  // The thumb is still down: the robot rests where it is whole on the goal, and no button looks
  // held.
  await expect(corridor.driveKey("forward")).toHaveAttribute("aria-pressed", "false");
  await corridor.waitForRobotToStop();
  expect(Math.abs((await corridor.robotX()) - 525)).toBeLessThanOrEqual(2);
  await fingers.lift();
  await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
  // The card's own, not one more that it lies over.
  await expect(next).toHaveCount(1);
  await next.tap();
  await expect(corridor.mazeMenu).toHaveAccessibleName("How far is the wall?, Maze menu");
  await expect(runProgram).toHaveCount(0);
});

const low = { ...phone, viewport: { width: 320, height: 640 } };
for (const [lang, begin, run] of [
  ["en", "Start with mission 1", "Run program"],
  ["de", "Mit Mission 1 beginnen", "Programm starten"],
  ["fr", "Commencer la mission 1", "Lancer le programme"],
] as const) {
  for (const device of [phone, low]) {
    const { width, height } = device.viewport;
    test(`reads the whole task above the keys in ${lang} at ${width} x ${height}, nothing scrolls`, async ({
      openWindow,
    }) => {
      const corridor = await openWindow(device);
      const { page } = corridor;
      await page.goto(`/?lang=${lang}`);
      await page.getByRole("button", { name: begin }).tap();
      await expect(page.getByRole("button", { name: run })).toBeInViewport({ ratio: 1 });
      const task = page.getByRole("region", { name: "Mission" }).getByRole("paragraph").first();
      const whole = await task.evaluate((text) => {
        const own = text.getBoundingClientRect();
        const around = text.parentElement?.getBoundingClientRect();
        return around !== undefined && own.top >= around.top && own.bottom <= around.bottom;
      });
      expect(whole).toBe(true);
      const tabPanel = page.getByRole("tabpanel");
      expect(await tabPanel.evaluate((panel) => panel.scrollHeight - panel.clientHeight)).toBe(0);
    });
  }
}

test("reads the number below the robot beside the small map on a low stage", async ({
  openWindow,
}) => {
  const corridor = await openWindow(low);
  await corridor.open();
  const { page } = corridor;
  await page.getByRole("button", { name: "Start with mission 1" }).tap();
  await expect(smallMap(page)).toBeVisible();
  await waitForAnimations(page);
  const grid = await boxOf(corridor.maze.grid);
  const map = await boxOf(smallMap(page));
  // The robot stands in the second square; beside the wall below it is the reading.
  const robotX = grid.x + 150 * SCALE;
  expect(map.x).toBeGreaterThan(robotX + 30);
});

test("sees the whole maze again, and follows the robot again", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await tab(page, "Drive").tap();
  await page.getByRole("button", { name: "Whole maze" }).tap();
  await expect(smallMap(page)).toBeHidden();
  const maze = await boxOf(corridor.maze.grid);
  const keys = await boxOf(page.getByRole("tablist"));
  expect(maze.x).toBeGreaterThanOrEqual(0);
  expect(maze.x + maze.width).toBeLessThanOrEqual(phone.viewport.width);
  expect(maze.y + maze.height).toBeLessThanOrEqual(keys.y);
  await page.getByRole("button", { name: "Follow the robot" }).tap();
  await expect(smallMap(page)).toBeVisible();
  expect((await boxOf(corridor.maze.grid)).width).toBeCloseTo(1100 * SCALE, 0);
});

test("hands over to the program and back without leaving the keys", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await tab(page, "Drive").tap();
  await page.getByRole("button", { name: "Run program" }).tap();
  await expect(page.getByText("The program is driving.")).toBeVisible();
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(80);
  await page.getByRole("button", { name: "Pause" }).tap();
  await expect(page.getByRole("button", { name: "Run program" })).toBeVisible();
  const fingers = await TouchInput.of(page);
  await fingers.down(await centreOf(corridor.driveKey("left")));
  await expect(page.getByText("You are driving.")).toBeVisible();
  // The system takes the finger away: the robot must not drive on.
  await fingers.cancel();
  await corridor.waitForRobotToStop();
  await expect(corridor.driveKey("left")).toHaveAttribute("aria-pressed", "false");
});

test("changes nothing in the maze while driving with a thumb", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await tab(page, "Drive").tap();
  await page.getByRole("button", { name: "Whole maze" }).tap();
  await corridor.maze.tap({ column: 3, row: 6 });
  await tab(page, "Program").tap();
  await corridor.maze.tap({ column: 2, row: 6 });
  await corridor.maze.expectSquare({ column: 2, row: 6 }, "block");
  await page.getByRole("button", { name: "Undo" }).first().tap();
  // The first tap would be undone now if it had changed anything.
  await corridor.maze.expectSquare({ column: 2, row: 6 }, "open");
  await expect(page.getByRole("button", { name: "Undo" }).first()).toBeDisabled();
});
