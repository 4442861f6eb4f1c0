/**
 * A maze larger than the stage has no effect on the next maze, which is drawn where it is edited.
 */
import type { Locator } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { StageScreenshot } from "./pages/stage-screenshot.ts";
import { phone, tab } from "./support/phone.ts";
import { withMotion } from "./support/with-motion.ts";

test.use(withMotion);

/**
 * seed of a maze with its goal far from the start, so that the stage scrolls until the goal is
 * reached
 */
const FAR_GOAL_SEED = "358";

/** Opens the presets: in a dialog on a desktop, in a tab on a phone. */
async function openPresets(corridor: CorridorPage, isPhone: boolean): Promise<Locator> {
  const { page } = corridor;
  if (isPhone) await tab(page, "Presets").tap();
  else await page.getByRole("button", { name: "Presets", exact: true }).click();
  return isPhone ? page.getByRole("tabpanel") : corridor.dialog("Presets");
}

async function chooseSmall(corridor: CorridorPage, isPhone: boolean): Promise<void> {
  const presets = await openPresets(corridor, isPhone);
  await presets.getByRole("button", { name: /^First steps/ }).click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("First steps, Maze menu");
  await corridor.dismissMessages();
}

async function chooseLarge(corridor: CorridorPage, isPhone: boolean): Promise<void> {
  const presets = await openPresets(corridor, isPhone);
  await presets.getByRole("slider", { name: "Size" }).fill("37");
  await presets.getByRole("textbox", { name: "Seed" }).fill(FAR_GOAL_SEED);
  await presets.getByRole("button", { name: "Open random maze" }).click();
  await expect(corridor.mazeMenu).toHaveAccessibleName(`Tree 37, seed ${FAR_GOAL_SEED}, Maze menu`);
  await expect(corridor.maze.grid).toHaveAttribute("aria-colcount", "37");
  await corridor.dismissMessages();
}

/**
 * Scrolls the stage with the wheel. Retries, as the stage may not be laid out for the new maze yet.
 */
async function scrollToTheEnd({ page, maze }: CorridorPage): Promise<void> {
  const before = await maze.grid.boundingBox();
  await page.locator("canvas").first().hover({ force: true });
  await expect(async () => {
    await page.mouse.wheel(5000, 5000);
    const top = async () => (await maze.grid.boundingBox())?.y;
    await expect.poll(top, { timeout: 2000 }).toBeLessThan(before?.y ?? 0);
  }).toPass();
}

async function drawsSmallAfterLarge(corridor: CorridorPage, isPhone: boolean): Promise<void> {
  await chooseSmall(corridor, isPhone);
  const picture = new StageScreenshot(corridor.page);
  const fresh = await picture.capture();

  await chooseLarge(corridor, isPhone);
  await scrollToTheEnd(corridor);
  await chooseSmall(corridor, isPhone);
  await picture.expectSame(fresh);
  await expect(corridor.robotPose).toHaveText(/^Robot at /);

  // A press edits the square that is drawn at that place.
  const square = { column: 4, row: 1 };
  if (isPhone) await tab(corridor.page, "Program").tap();
  const before = await picture.capture();
  await corridor.maze.click(square);
  await picture.expectDifferent(before);
  await corridor.maze.expectSquare(square, "block");
}

async function showsWholeMission(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await chooseLarge(corridor, false);
  // A maze from the presets opens with an empty program.
  const presets = await openPresets(corridor, false);
  await presets.getByText("Show an algorithm").click();
  await presets.getByRole("button", { name: /^Right wall/ }).click();
  await corridor.dismissMessages();
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect.poll(async () => (await corridor.maze.grid.boundingBox())?.y).toBeLessThan(0);
  await new LessonsPanel(page).openMission(2);
  await expect(corridor.maze.grid).not.toHaveAttribute("aria-colcount", "37");
  await expect(corridor.maze.grid).toBeInViewport({ ratio: 1 });
}

test("draws a small maze at its squares after a large one was scrolled, on a phone", async ({
  openWindow,
}) => {
  const corridor = await openWindow(phone);
  await corridor.open();
  await drawsSmallAfterLarge(corridor, true);
});

test("draws a small maze and a mission after a large maze, on a desktop", async ({ corridor }) => {
  await test.step("draws a small maze at its squares after a large one was scrolled", () =>
    drawsSmallAfterLarge(corridor, false));
  await test.step("shows a whole mission after a large maze was driven at full speed", () =>
    showsWholeMission(corridor));
});
