/** A new student, guided only by the texts on the stage and in the panel. */
import { expect, test } from "./fixtures.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { horizontalOverflow } from "./support/layout.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

test("a new student solves the first mission within a minute of the first visit", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  // Two actions: one click on the invitation, and one held key. The robot needs 4 s of simulated
  // time.
  await lessons.invitation.getByRole("button", { name: "Start with mission 1" }).click();
  await lessons.expectMission(1);
  await expect(corridor.driver("Me")).toBeChecked();
  await expect(lessons.card).toContainText("or hold W or ↑.");
  await page.keyboard.down("w");
  await expect(lessons.outcome).toHaveText(/^Task solved after \d\.\d s$/);
  await page.keyboard.up("w");
  await expect(page.getByRole("main").getByText(/^Task solved after/)).toBeVisible();
  const solved = page.getByRole("region", { name: "Solved!" });
  await solved.getByRole("button", { name: "Next mission" }).click();
  await lessons.expectMission(2);
});

test("stops the robot where the mission is solved while the key is held, and drives on with a new press", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(1);
  await page.keyboard.down("w");
  await expect(lessons.outcome).toHaveText(/^Task solved after/);
  // A keyboard repeats a held key.
  await page.keyboard.down("w");
  await corridor.waitForRobotToStop();
  const goal = await corridor.robotX();
  expect(Math.abs(goal - 525)).toBeLessThanOrEqual(2);
  await page.keyboard.up("w");
  await page.keyboard.down("w");
  await expect.poll(() => corridor.robotX()).toBeGreaterThan(goal);
  await page.keyboard.up("w");
});

test("accepts Run as a solution of the first mission", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await lessons.invitation.getByRole("button", { name: "Start with mission 1" }).click();
  await lessons.expectMission(1);
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  // A manual mission has no line count.
  await expect(lessons.outcome).toHaveText(/^Task solved after \d\.\d s$/);
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved.getByRole("term")).toHaveText(["run time", "bumps"]);
  await solved.getByRole("button", { name: "Next mission" }).click();
  await lessons.expectMission(2);
});

test("does not show a declined invitation again", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await lessons.invitation.getByRole("button", { name: "Not now" }).click();
  await expect(lessons.invitation).toBeHidden();
  await corridor.open();
  await expect(lessons.invitation).toBeHidden();
});

test("solves a mission by keyboard alone", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await page.getByRole("banner").getByRole("button", { name: "Lessons" }).focus();
  await page.keyboard.press("Enter");
  const mission = lessons.path.getByRole("button", { name: /^4\. / });
  await expect(mission).toBeVisible();
  await mission.focus();
  await page.keyboard.press("Enter");
  await lessons.expectMission(4);
  await corridor.program.line(2).focus();
  await page.keyboard.press("Alt+ArrowUp");
  await corridor.speed.selectOption("max");
  await page.keyboard.press("Control+Enter");
  await expect(lessons.outcome).toHaveText("Task solved. Lines used: 2 of 2");
});

test("lists the missions in chapters, each with its progress, and opens hints one by one, without axe violations", async ({
  corridor,
  page,
}) => {
  await page.evaluate(() => {
    const done = { "make-it-move": { lines: 0, ticks: 240 }, "own-line": { lines: 1, ticks: 400 } };
    localStorage.setItem("corridor.lessons", JSON.stringify({ done, works: {}, home: null }));
  });
  await corridor.open();
  const lessons = new LessonsPanel(page);
  await lessons.openPath();
  const chapter = (name: string) => lessons.path.getByRole("region", { name });
  await expect(chapter("Meet the robot")).toContainText("1 of 2 done");
  await expect(chapter("Write lines")).toContainText("1 of 4 done");
  await expect(chapter("Write lines").getByRole("button")).toHaveCount(4);
  await expect(chapter("Turns and the order of lines")).toContainText("0 of 4 done");
  await expect(chapter("Solve whole mazes")).toContainText("0 of 4 done");
  await expect(lessons.path.getByText("2 of 14 done")).toBeVisible();
  await expectNoAxeViolations(page, "path of missions");
  await page.keyboard.press("Escape");
  await lessons.openMission(12);
  await expect(lessons.hints).toHaveCount(0);
  await lessons.button("Show a hint").click();
  await expect(lessons.hints).toHaveCount(1);
  await lessons.button("Show hint 2 of 3").click();
  await lessons.button("Show hint 3 of 3").click();
  await expect(lessons.hints).toHaveCount(3);
  await expect(lessons.button(/^Show/)).toHaveCount(0);
  await lessons.button("Check in all 3 mazes").click();
  await expect(lessons.card).toContainText("Passes in 1 of 3.");
  await expectNoAxeViolations(page, "a mission that does not pass yet");
});

test("has no horizontal overflow in a mission at 320 x 700", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 320, height: 700 } });
  await corridor.open();
  const { page } = corridor;
  const lessons = new LessonsPanel(page);
  expect(await horizontalOverflow(page), "invitation").toEqual([]);
  await page.getByRole("banner").getByRole("button", { name: "More" }).click();
  await page.getByRole("dialog", { name: "More" }).getByRole("button", { name: "Lessons" }).click();
  await expect(lessons.path).toBeVisible();
  expect(await horizontalOverflow(page), "path").toEqual([]);
  await lessons.path.getByRole("button", { name: /^12\. / }).click();
  await lessons.button("Check in all 3 mazes").click();
  await expect(lessons.card).toContainText("Passes in 1 of 3.");
  expect(await horizontalOverflow(page), "mission").toEqual([]);
  // Only a program may drive there. The keys have the slim card.
  await expect(page.getByRole("tab", { name: "Drive" })).toBeHidden();
  await lessons.openMissionOnPhone(2);
  await expect(page.getByRole("tab", { name: "Drive", selected: true })).toBeVisible();
  expect(await horizontalOverflow(page), "slim").toEqual([]);
});
