/**
 * What the lessons store: progress, in every tab, and the user's own maze while a mission is open.
 */
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

test("returns to the user's own maze, keeps and merges the progress of two tabs, and reopens a mission for manual driving", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  await test.step("returns to the user's own maze", () => returnHome(corridor, lessons));
  await test.step("merges the progress of two tabs, and keeps it after a reload", () =>
    mergeTabs(corridor, lessons));
  await page.keyboard.press("Escape");
  await test.step("reopens a mission for manual driving with Me as the driver", () =>
    reopenByHand(corridor, lessons));
});

async function returnHome(corridor: CorridorPage, lessons: LessonsPanel): Promise<void> {
  await corridor.maze.click({ column: 2, row: 6 });
  await corridor.program.action(1).selectOption("turn 180");
  await lessons.openMission(6);
  await corridor.program.button("Add line").click();
  await expect(corridor.program.lines).toHaveCount(1);
  await lessons.button("Back to my maze").click();
  await expect(lessons.card).toBeHidden();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await corridor.maze.expectSquare({ column: 2, row: 6 }, "block");
  await expect(corridor.program.action(1)).toHaveValue("turn 180");
  // The attempt is still as it was left.
  await lessons.openMission(6);
  await expect(corridor.program.lines).toHaveCount(1);
}

async function mergeTabs(corridor: CorridorPage, lessons: LessonsPanel): Promise<void> {
  const { page } = corridor;
  await lessons.openMission(3);
  const other = new CorridorPage(await page.context().newPage());
  await other.open();
  const otherLessons = new LessonsPanel(other.page);
  await otherLessons.openMission(4);
  await other.program.line(2).focus();
  await other.page.keyboard.press("Alt+ArrowUp");
  await other.speed.selectOption("max");
  await other.run.click();
  await expect(otherLessons.outcome).toHaveText("Task solved. Lines used: 2 of 2");
  await page.bringToFront();
  await corridor.program.action(1).selectOption("turn 180");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText("Task solved. Lines used: 1 of 1");
  await lessons.openPath();
  await expect(lessons.path).toContainText("2 of 14 done");
  await other.page.bringToFront();
  await otherLessons.openPath();
  await expect(otherLessons.path).toContainText("2 of 14 done");
  await other.page.close();
  await corridor.open();
  await lessons.expectMission(3);
  await expect(corridor.program.action(1)).toHaveValue("turn 180");
  await lessons.openPath();
  await expect(lessons.path).toContainText("2 of 14 done");
  await expect(lessons.path.getByRole("button", { name: /^3\. / })).toContainText("Done");
  await lessons.path.getByRole("button", { name: "Delete my progress" }).click();
  await expect(lessons.path).toContainText("0 of 14 done");
}

async function reopenByHand(corridor: CorridorPage, lessons: LessonsPanel): Promise<void> {
  const { page } = corridor;
  await lessons.openMission(2);
  // The robot is at its start, wherever the run before ended.
  await expectByHand(corridor);
  await corridor.reload();
  await lessons.expectMission(2);
  await expectByHand(corridor);
  // The same from a new tab, and from the list of mazes.
  const other = new CorridorPage(await page.context().newPage());
  await other.open();
  await expectByHand(other);
  await other.mazeMenu.click();
  await other.page.getByRole("button", { name: /^New empty maze/ }).click();
  await expect(other.driver("Me")).toBeChecked();
  await other.selectDriver("Program");
  await other.mazeMenu.click();
  await other.page
    .getByRole("button", { name: /How far is the wall/ })
    .first()
    .click();
  await expectByHand(other);
}

/** The mission allows one driver, so that there is nothing to choose. */
async function expectByHand(page: CorridorPage): Promise<void> {
  await expect(page.runNote).toHaveText("You drive here. Hold a drive key.");
  await expect(page.driveKey("forward")).toBeVisible();
  await expect(page.driver("Me")).toHaveCount(0);
}
