/**
 * Driving on a phone with a thumb: the stage follows the robot, and manual missions can be solved.
 */
import { lessonOfTasks } from "@corridor/challenge/testing";
import { encodeLink } from "@corridor/link";
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { chooseLanguage } from "./support/choose-language.ts";
import { clearStorageOnLoad } from "./support/clear-storage.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";
import { TouchInput, centreOf } from "./support/touch-input.ts";
import { unreadableTexts } from "./support/layout.ts";
import { lessonTask } from "./support/lesson-task.ts";
import { boxOf, phone, smallestPhone, tab } from "./support/phone.ts";
import { Texts } from "./support/texts.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

const small = { ...phone, viewport: { width: 320, height: 640 } };

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

test("switches between program, thumb and the whole maze, and follows the robot with a minimap", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  const touch = await TouchInput.of(page);

  await test.step("switches to the program and back without leaving the keys", async () => {
    await tab(page, "Drive").tap();
    await page.getByRole("button", { name: "Run program" }).tap();
    await expect(page.getByText("The program is driving.")).toBeVisible();
    await expect.poll(() => corridor.robotX()).toBeGreaterThan(80);
    await page.getByRole("button", { name: "Pause" }).tap();
    await expect(page.getByRole("button", { name: "Run program" })).toBeVisible();
    await expect(page.getByText("The program is not running.")).toBeVisible();
    await touch.down(await centreOf(corridor.driveKey("left")));
    await expect(page.getByText("You are driving.")).toBeVisible();
    // The system cancels the touch: the robot must stop.
    await touch.cancel();
    await corridor.waitForRobotToStop();
    await expect(corridor.driveKey("left")).toHaveAttribute("aria-pressed", "false");
  });

  await test.step("switches to the whole maze, which a thumb does not edit, and to following the robot", async () => {
    await page.getByRole("button", { name: "Whole maze" }).tap();
    await expect(minimap(page)).toBeHidden();
    const maze = await boxOf(corridor.maze.grid);
    const keys = await boxOf(page.getByRole("tablist"));
    expect(maze.x).toBeGreaterThanOrEqual(0);
    expect(maze.x + maze.width).toBeLessThanOrEqual(phone.viewport.width);
    expect(maze.y + maze.height).toBeLessThanOrEqual(keys.y);
    await corridor.maze.tap({ column: 1, row: 0 });
    await page.getByRole("button", { name: "Follow the robot" }).tap();
    await expect(minimap(page)).toBeVisible();
    expect((await boxOf(corridor.maze.grid)).width).toBeCloseTo(1100 * SCALE, 0);
    await tab(page, "Program").tap();
    await corridor.maze.tap({ column: 2, row: 0 });
    await corridor.maze.expectSquare({ column: 2, row: 0 }, "block");
    const undo = page.getByRole("button", { name: "Undo" }).first();
    await undo.tap();
    // Undo would revert the first tap here, if that tap had changed anything.
    await corridor.maze.expectSquare({ column: 2, row: 0 }, "open");
    await expect(undo).toBeDisabled();
  });

  await test.step("follows the robot with a minimap while a phone drives", async () => {
    await choose(corridor, "Empty");
    await tab(page, "Drive").tap();
    await expect(corridor.transport).toBeHidden();
    await expect(minimap(page)).toBeVisible();
    // The sheet grows for the keys, and the minimap moves with it.
    await waitForAnimations(page);
    const columns = Number(await corridor.maze.grid.getAttribute("aria-colcount"));
    expect((await boxOf(corridor.maze.grid)).width).toBeCloseTo(columns * 100 * SCALE, 0);
    const before = { maze: await boxOf(corridor.maze.grid), dot: await robotOnMap(page) };

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
});

/** The robot's position on the minimap, from the minimap's corner. */
async function robotOnMap(page: Page) {
  const map = await boxOf(minimap(page));
  const { x, y } = await centreOf(minimap(page).locator("svg").last());
  return { x: x - map.x, y: y - map.y };
}

test("shows the whole task above the keys without scrolling, and solves manual missions with a thumb", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  const { page } = corridor;
  await page.getByRole("button", { name: "Start with mission 1" }).tap();
  await expect(corridor.driveKey("forward")).toBeVisible();
  await waitForAnimations(page);
  // The text mentions no keyboard, since a phone has none.
  await expect(page.getByRole("region", { name: "Mission" })).toHaveText(
    "Hold the forward key until the robot stands on the green goal.",
  );

  await expectWholeTask(page, Texts.load("en"), "English, 390 px");
  await page.setViewportSize(small.viewport);
  await expectWholeTask(page, Texts.load("en"), "English, 320 px");
  await expectReadingBesideMinimap(corridor);
  let shown = "en";
  for (const tag of ["de", "fr"]) {
    await chooseLanguage(page, Texts.load(shown), tag);
    shown = tag;
    for (const size of [small.viewport, phone.viewport]) {
      await page.setViewportSize(size);
      await expectWholeTask(page, Texts.load(tag), `${tag}, ${size.width} px`);
    }
  }
  await chooseLanguage(page, Texts.load(shown), "en");

  await test.step("solves manual missions with a thumb, with every button in full view", async () => {
    const runProgram = page.getByRole("button", { name: "Run program" });
    await expect(runProgram).toBeInViewport({ ratio: 1 });
    expect(await unreadableTexts(page), "mission 1").toEqual([]);
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
    const next = page.getByRole("button", { name: "Next mission" });
    await expect(next).toHaveCount(1);
    await next.tap();
    await expect(corridor.mazeMenu).toHaveAccessibleName("How far is the wall?, Maze menu");
    await runProgram.waitFor({ state: "detached" });
  });
});

async function expectWholeTask(page: Page, texts: Texts, state: string): Promise<void> {
  await waitForAnimations(page);
  const run = page.getByRole("button", { name: texts.t("shell.run.runProgram") });
  await expect(run, state).toBeInViewport({ ratio: 1 });
  const mission = page.getByRole("region", { name: texts.t("missions.card.label"), exact: true });
  const task = mission.getByRole("paragraph").first();
  const whole = await task.evaluate((text) => {
    const own = text.getBoundingClientRect();
    const around = text.parentElement?.getBoundingClientRect();
    return around !== undefined && own.top >= around.top && own.bottom <= around.bottom;
  });
  expect(whole, state).toBe(true);
  const tabPanel = page.getByRole("tabpanel");
  expect(await tabPanel.evaluate((panel) => panel.scrollHeight - panel.clientHeight), state).toBe(
    0,
  );
}

/** Expects that the minimap does not cover the reading below the robot on a small stage. */
async function expectReadingBesideMinimap({ page, maze }: CorridorPage): Promise<void> {
  await expect(minimap(page)).toBeVisible();
  await waitForAnimations(page);
  const grid = await boxOf(maze.grid);
  const map = await boxOf(minimap(page));
  // The robot is in the second square. Its reading is beside the wall below it.
  const robotX = grid.x + 150 * SCALE;
  expect(map.x).toBeGreaterThan(robotX + 30);
}

test("shows the result of a drive with the task, and covers neither robot nor goal with a button", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  const { page } = corridor;
  await clearStorageOnLoad(page);
  const words = {
    task: "Drive to the goal without a bump, and stop fully on the green square.",
    short: "",
    hints: [],
  };
  const byHand = lessonTask("By hand", [], { words, allowed: { drivers: ["me"] } });
  const link = encodeLink({ lesson: lessonOfTasks("By hand", [byHand]) });
  if (!link.ok) throw new Error(link.code);
  const touch = await TouchInput.of(page);
  // A new fragment alone would not load the page again.
  for (const [search, { width, height }] of [
    ["", phone.viewport],
    ["?lang=en", smallestPhone.viewport],
  ] as const) {
    await test.step(`shows the result of a drive with the task at ${width} x ${height}`, async () => {
      await page.setViewportSize({ width, height });
      await corridor.open(`/${search}#${link.text}`);
      await corridor.dismissMessages();
      const mission = page.getByRole("region", { name: "Mission" });
      const task = mission.getByText(words.task);
      const result = mission.getByRole("note");
      await expect(task).toBeInViewport({ ratio: 1 });
      await waitForAnimations(page);
      const stage = await boxOf(page.getByRole("main"));
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
  await page.setViewportSize(phone.viewport);
  for (const [search, lang, start, goal] of [
    ["", "en", { column: 5, row: 4 }, { column: 6, row: 2 }],
    ["?lang=ar", "ar", { column: 5, row: 4 }, { column: 4, row: 2 }],
  ] as const) {
    await test.step(`covers neither robot nor goal with the button for the whole maze, in ${lang}`, async () => {
      const square = encodeLink({
        maze: {
          format: "corridor/maze",
          version: 1,
          name: "Square",
          blocks: Array.from({ length: 11 }, () => ".".repeat(11)),
          start: { ...start, heading: "north" },
          goals: [goal],
        },
      });
      await page.goto(`/${search}#${square.ok ? square.text : ""}`);
      const texts = Texts.load(lang);
      await page.getByRole("tab", { name: texts.t("shell.tabs.drive") }).tap();
      await expect(minimap(page)).toBeVisible();
      await waitForAnimations(page);
      // The maze is scrolled to the robot when the simulator has placed it.
      await expect(async () => {
        const button = await boxOf(page.getByRole("button", { name: texts.t("phone.wholeMaze") }));
        const { x, y } = await boxOf(page.getByRole("grid"));
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
      }).toPass({ timeout: 45_000 });
    });
  }
});
