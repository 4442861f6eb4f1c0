// cspell:words beginnen Programm starten
/**
 * Driving on a phone with a thumb: the stage follows the robot, and manual missions can be solved.
 */
import { lessonOfTasks } from "@corridor/challenge/testing";
import { encodeLink } from "@corridor/link";
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { TouchInput, centreOf } from "./support/touch-input.ts";
import { unreadableTexts } from "./support/layout.ts";
import { lessonTask } from "./support/lesson-task.ts";
import { boxOf, phone, smallestPhone, tab } from "./support/phone.ts";
import { Texts } from "./support/texts.ts";

/** pixels per cm while the stage follows the robot */
const SCALE = 0.6;

/** The minimap. It is a picture without a role. */
function minimap(page: Page): Locator {
  return page.locator("[data-map]");
}

/** Selects a maze in the Presets tab. */
async function choose(corridor: CorridorPage, title: string): Promise<void> {
  await tab(corridor.page, "Presets").tap();
  await corridor.page.getByRole("button", { name: new RegExp(`^${title}`) }).tap();
  await expect(corridor.mazeMenu).toHaveAccessibleName(`${title}, Maze menu`);
}

test("follows the robot with a minimap while a phone drives", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await choose(corridor, "Empty");
  await tab(page, "Drive").tap();
  await expect(corridor.transport).toBeHidden();
  await expect(minimap(page)).toBeVisible();
  // The sheet grows for the keys, and the minimap moves with it.
  await waitForAnimations(page);
  const columns = Number(await corridor.maze.grid.getAttribute("aria-colcount"));
  expect((await boxOf(corridor.maze.grid)).width).toBeCloseTo(columns * 100 * SCALE, 0);
  const before = { maze: await boxOf(corridor.maze.grid), dot: await robotOnMap(page) };

  const touch = await TouchInput.of(page);
  await touch.down(await centreOf(corridor.driveKey("forward")));
  await expect(page.getByText("You are driving.")).toBeVisible();
  await expect.poll(async () => (await boxOf(corridor.maze.grid)).x).toBeLessThan(before.maze.x);
  await touch.lift();
  await corridor.waitForRobotToStop();

  // The stage has scrolled so that the robot is in its centre.
  const maze = await boxOf(corridor.maze.grid);
  expect(maze.x + (await corridor.robotX()) * SCALE).toBeCloseTo(phone.viewport.width / 2, -1);
  const dot = await robotOnMap(page);
  expect(dot.x).toBeGreaterThan(before.dot.x);
  expect(dot.y).toBeCloseTo(before.dot.y, 0);
});

/** The robot's position on the minimap, from the minimap's corner. */
async function robotOnMap(page: Page) {
  const map = await boxOf(minimap(page));
  const { x, y } = await centreOf(minimap(page).locator("svg").last());
  return { x: x - map.x, y: y - map.y };
}

test("solves manual missions with a thumb, with every button in full view", async ({
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
  // The text mentions no keyboard, since a phone has none.
  await expect(page.getByRole("region", { name: "Mission" })).toHaveText(
    "Hold the forward key until the robot stands on the green goal.",
  );
  const touch = await TouchInput.of(page);
  await touch.down(await centreOf(corridor.driveKey("forward")));
  await expect(page.getByRole("note")).toHaveText(/^Task solved after/);
  // The thumb is still down: the robot stops fully on the goal, and no button appears pressed.
  await expect(corridor.driveKey("forward")).toHaveAttribute("aria-pressed", "false");
  await corridor.waitForRobotToStop();
  expect(Math.abs((await corridor.robotX()) - 525)).toBeLessThanOrEqual(2);
  await touch.lift();
  await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
  // Only the card's own button, not a second one below the card.
  await expect(next).toHaveCount(1);
  await next.tap();
  await expect(corridor.mazeMenu).toHaveAccessibleName("How far is the wall?, Maze menu");
  await expect(runProgram).toHaveCount(0);
});

const small = { ...phone, viewport: { width: 320, height: 640 } };
for (const [lang, start, run] of [
  ["en", "Start with mission 1", "Run program"],
  ["de", "Mit Mission 1 beginnen", "Programm starten"],
  ["fr", "Commencer la mission 1", "Lancer le programme"],
] as const) {
  for (const device of [phone, small]) {
    const { width, height } = device.viewport;
    test(`shows the whole task above the keys in ${lang} at ${width} x ${height} without scrolling`, async ({
      openWindow,
    }) => {
      const corridor = await openWindow(device);
      const { page } = corridor;
      await page.goto(`/?lang=${lang}`);
      await page.getByRole("button", { name: start }).tap();
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

for (const device of [phone, smallestPhone]) {
  const { width, height } = device.viewport;
  test(`shows the result of a drive with the task at ${width} x ${height}`, async ({
    openWindow,
  }) => {
    const corridor = await openWindow(device);
    const words = {
      task: "Drive to the goal without a bump, and stop fully on the green square.",
      short: "",
      hints: [],
    };
    const byHand = lessonTask("By hand", [], { words, allowed: { drivers: ["me"] } });
    const link = encodeLink({ lesson: lessonOfTasks("By hand", [byHand]) });
    if (!link.ok) throw new Error(link.code);
    await corridor.open(`/#${link.text}`);
    await corridor.dismissMessages();
    const { page } = corridor;
    const mission = page.getByRole("region", { name: "Mission" });
    const task = mission.getByText(words.task);
    const result = mission.getByRole("note");
    await expect(task).toBeInViewport({ ratio: 1 });
    await waitForAnimations(page);
    const stage = await boxOf(page.getByRole("main"));
    const touch = await TouchInput.of(page);
    await touch.down(await centreOf(corridor.driveKey("reverse")));
    await expect(result).toHaveText(/^Bump at/);
    await touch.lift();
    await expect(result).toBeInViewport({ ratio: 1 });
    await expect(task).toBeInViewport({ ratio: 1 });
    await expect(corridor.driveKey("forward")).toBeInViewport({ ratio: 1 });
    expect(await boxOf(page.getByRole("main"))).toEqual(stage);
    const show = mission.getByRole("button", { name: "Show the task" });
    if (height >= 704) return expect(show).toBeHidden();
    // Only the first words, until they are unfolded.
    const isCut = () => task.evaluate((text) => text.scrollWidth > text.clientWidth);
    expect(await isCut()).toBe(true);
    await show.tap();
    expect(await isCut()).toBe(false);
    await mission.getByRole("button", { name: "Hide the task" }).tap();
    expect(await isCut()).toBe(true);
  });
}

test("does not cover the reading below the robot with the minimap on a small stage", async ({
  openWindow,
}) => {
  const corridor = await openWindow(small);
  await corridor.open();
  const { page } = corridor;
  await page.getByRole("button", { name: "Start with mission 1" }).tap();
  await expect(minimap(page)).toBeVisible();
  await waitForAnimations(page);
  const grid = await boxOf(corridor.maze.grid);
  const map = await boxOf(minimap(page));
  // The robot is in the second square. Its reading is beside the wall below it.
  const robotX = grid.x + 150 * SCALE;
  expect(map.x).toBeGreaterThan(robotX + 30);
});

test("switches to the whole maze, and to following the robot", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await tab(page, "Drive").tap();
  await page.getByRole("button", { name: "Whole maze" }).tap();
  await expect(minimap(page)).toBeHidden();
  const maze = await boxOf(corridor.maze.grid);
  const keys = await boxOf(page.getByRole("tablist"));
  expect(maze.x).toBeGreaterThanOrEqual(0);
  expect(maze.x + maze.width).toBeLessThanOrEqual(phone.viewport.width);
  expect(maze.y + maze.height).toBeLessThanOrEqual(keys.y);
  await page.getByRole("button", { name: "Follow the robot" }).tap();
  await expect(minimap(page)).toBeVisible();
  expect((await boxOf(corridor.maze.grid)).width).toBeCloseTo(1100 * SCALE, 0);
});

for (const [lang, start, goal] of [
  ["en", { column: 5, row: 4 }, { column: 6, row: 2 }],
  ["ar", { column: 5, row: 4 }, { column: 4, row: 2 }],
] as const) {
  test(`covers neither robot nor goal with the button for the whole maze, in ${lang}`, async ({
    openWindow,
  }) => {
    const corridor = await openWindow(phone);
    const link = encodeLink({
      maze: {
        format: "corridor/maze",
        version: 1,
        name: "Square",
        blocks: Array.from({ length: 11 }, () => ".".repeat(11)),
        start: { ...start, heading: "north" },
        goals: [goal],
      },
    });
    const { page } = corridor;
    await page.goto(`/?lang=${lang}#${link.ok ? link.text : ""}`);
    const texts = Texts.load(lang);
    await page.getByRole("tab", { name: texts.t("shell.tabs.drive") }).tap();
    await expect(minimap(page)).toBeVisible();
    await waitForAnimations(page);
    const button = await boxOf(page.getByRole("button", { name: texts.t("phone.wholeMaze") }));
    const grid = page.getByRole("grid");
    const { x, y } = await boxOf(grid);
    const side = 100 * SCALE;
    for (const { column, row } of [start, goal]) {
      const [left, top] = [x + column * side, y + row * side];
      expect(top + side, "the square is in sight").toBeGreaterThan(button.y);
      const isApart =
        left >= button.x + button.width ||
        left + side <= button.x ||
        top >= button.y + button.height;
      expect(isApart).toBe(true);
    }
  });
}

test("switches to the program and back without leaving the keys", async ({ openWindow }) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await tab(page, "Drive").tap();
  await page.getByRole("button", { name: "Run program" }).tap();
  await expect(page.getByText("The program is driving.")).toBeVisible();
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(80);
  await page.getByRole("button", { name: "Pause" }).tap();
  await expect(page.getByRole("button", { name: "Run program" })).toBeVisible();
  await expect(page.getByText("The program is not running.")).toBeVisible();
  const touch = await TouchInput.of(page);
  await touch.down(await centreOf(corridor.driveKey("left")));
  await expect(page.getByText("You are driving.")).toBeVisible();
  // The system cancels the touch: the robot must stop.
  await touch.cancel();
  await corridor.waitForRobotToStop();
  await expect(corridor.driveKey("left")).toHaveAttribute("aria-pressed", "false");
});

test("does not edit the maze while a thumb drives", async ({ openWindow }) => {
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
  // Undo would revert the first tap here, if that tap had changed anything.
  await corridor.maze.expectSquare({ column: 2, row: 6 }, "open");
  await expect(page.getByRole("button", { name: "Undo" }).first()).toBeDisabled();
});
