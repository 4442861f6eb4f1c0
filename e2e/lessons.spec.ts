/** A new student, guided only by the texts on the stage and in the panel. */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { horizontalOverflow } from "./support/layout.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

interface OpenPage {
  corridor: CorridorPage;
  page: Page;
  lessons: LessonsPanel;
}

/** The narrowest phone. */
const narrow = { width: 320, height: 700 };

test("a new student solves the first mission within a minute of the first visit, and the robot stops there and drives on with a new press", async ({
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
  await test.step("stops where the mission is solved while the key is held", async () => {
    // A keyboard repeats a held key.
    await page.keyboard.down("w");
    await corridor.waitForRobotToStop();
    expect(Math.abs((await corridor.robotX()) - 525)).toBeLessThanOrEqual(2);
    await page.keyboard.up("w");
  });
  await expect(page.getByRole("main").getByText(/^Task solved after/)).toBeVisible();
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved.getByRole("button", { name: "Next mission" })).toBeVisible();
  await test.step("drives on with a new press", async () => {
    const goal = await corridor.robotX();
    await page.keyboard.down("w");
    await expect.poll(() => corridor.robotX()).toBeGreaterThan(goal);
    await page.keyboard.up("w");
  });
});

test("declines the invitation, solves missions with Run and by keyboard alone, and lists them in chapters, also at 320 px", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  const open: OpenPage = { corridor, page, lessons };
  await test.step("does not show a declined invitation again", async () => {
    await page.setViewportSize(narrow);
    expect(await horizontalOverflow(page), "invitation").toEqual([]);
    await page.setViewportSize(smallWindow.viewport);
    await lessons.invitation.getByRole("button", { name: "Not now" }).click();
    await expect(lessons.invitation).toBeHidden();
    await corridor.open();
    await expect(lessons.invitation).toBeHidden();
  });
  await test.step("accepts Run as a solution of the first mission", () => runFirst(open));
  await test.step("solves a mission by keyboard alone", () => useKeyboard(open));
  await lessons.button("Back to my maze").click();
  await expect(lessons.card).toBeHidden();
  await test.step("lists the missions in chapters, each with its progress", () =>
    listMissions(open));
  await test.step("opens hints one by one", () => openHints(open));
  await test.step("has no horizontal overflow in a mission at 320 x 700", () => openOnPhone(open));
});

async function runFirst({ corridor, page, lessons }: OpenPage): Promise<void> {
  await lessons.openMission(1);
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  // A manual mission has no line count.
  await expect(lessons.outcome).toHaveText(/^Task solved after \d\.\d s$/);
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved.getByRole("term")).toHaveText(["run time", "bumps"]);
  await solved.getByRole("button", { name: "Next mission" }).click();
  await lessons.expectMission(2);
}

async function useKeyboard({ corridor, page, lessons }: OpenPage): Promise<void> {
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
}

async function listMissions({ corridor, page, lessons }: OpenPage): Promise<void> {
  await page.evaluate(() => {
    const done = { "make-it-move": { lines: 0, ticks: 240 }, "own-line": { lines: 1, ticks: 400 } };
    localStorage.setItem("corridor.lessons", JSON.stringify({ done, works: {}, home: null }));
  });
  await corridor.open();
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
}

async function openHints({ page, lessons }: OpenPage): Promise<void> {
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
}

/** @param open with a mission for the program */
async function openOnPhone({ page, lessons }: OpenPage): Promise<void> {
  await page.setViewportSize(narrow);
  expect(await horizontalOverflow(page), "mission").toEqual([]);
  await page.getByRole("banner").getByRole("button", { name: "More" }).click();
  await page.getByRole("dialog", { name: "More" }).getByRole("button", { name: "Lessons" }).click();
  await expect(lessons.path).toBeVisible();
  expect(await horizontalOverflow(page), "path").toEqual([]);
  await page.keyboard.press("Escape");
  await expect(lessons.path).toBeHidden();
  // Only a program may drive there. The keys have the slim card.
  await expect(page.getByRole("tab", { name: "Drive" })).toBeHidden();
  await lessons.openMissionOnPhone(2);
  await expect(page.getByRole("tab", { name: "Drive", selected: true })).toBeVisible();
  expect(await horizontalOverflow(page), "slim").toEqual([]);
}
