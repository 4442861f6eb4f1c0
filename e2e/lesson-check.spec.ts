/** The check of a student's program in the given and the unseen mazes of a task. */
import { expect, test } from "./fixtures.ts";
import { drop, Lesson } from "./pages/lesson-card.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { straight } from "./support/lesson-task.ts";
import { lesson, side, taskOf, type Opened } from "./support/student-lesson.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

test("counts a task as solved only after a check in its unseen mazes, whose runs can be opened, stops a check at once, and has a code for a drive by hand", async ({
  corridor,
  page,
}) => {
  const opened = new Lesson(page);
  const student: Opened = { corridor, page, opened };
  // A small window has the next step only once.
  await page.setViewportSize({ width: 1440, height: 900 });
  await test.step("a task is solved after a check in its unseen mazes", () => checkUnseen(student));
  await page.setViewportSize(wideWindow.viewport);
  await test.step("a check stops at once, with the mazes so far", () => stopCheck(student));
  await test.step("a missed goal is the end of the time, never wrong", () => missGoal(student));
  await test.step("the completion code contains the commands of a drive by hand", async () => {
    const allowed = { ...taskOf("").allowed, drivers: ["me"] as const };
    await drop(page, { ...lesson, tasks: [{ ...taskOf("By hand"), allowed }] });
    await expect(page.getByText("Solve By hand.")).toBeVisible();
    await page.keyboard.down("w");
    const code = page.getByRole("region", { name: "Completion code" });
    await expect(code.getByRole("button", { name: "Copy code" })).toBeVisible();
    await page.keyboard.up("w");
    await corridor.waitForRobotToStop();
    await expect(code.locator("code")).toHaveText(/^[\w-]{10,60}$/);
  });
});

async function checkUnseen({ corridor, page, opened }: Opened): Promise<void> {
  const unseen = { kind: "tree", columns: 11, rows: 11, seed: 7, count: 20, pass: 20 } as const;
  const checks = { bumps: 0, seconds: 900 };
  await drop(page, { ...lesson, tasks: [taskOf("Every maze", { unseen, checks }), taskOf("Two")] });
  await expect(opened.card).toContainText(
    "Your program is also tested in unseen mazes. It must pass in 20 of 20.",
  );
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(
    page.getByRole("main").getByText("Works in this maze. Now check all 21."),
  ).toHaveCount(2);
  await expect(opened.task(1)).toHaveAccessibleName("1 Every maze");
  const check = opened.card.getByRole("button", { name: "Check in all 21 mazes" });
  await page.keyboard.press("Escape");
  await check.click();
  await expect(opened.outcome).toHaveText(/^Tree 1 of seed 7: Bump at /);
  await expect(opened.card).toContainText(
    /Passes in 1 of 21\. First failure: Tree 1 of seed 7, bump at \d+\.\d s, “otherwise”/,
  );

  await watchFailures({ corridor, page, opened });

  await corridor.program.addLine("right >", "60", "delayed right 90");
  await corridor.program.addLine("front <", "50", "left 90");
  await check.click();
  await expect(opened.outcome).toHaveText("Task solved. Lines used: 2 of 3");
  await expect(opened.task(1)).toHaveAccessibleName("1 Every maze solved");
  await openPassingMaze({ corridor, page, opened });
}

/** Opens an unseen maze in which the program passes, and goes back to the task. */
async function openPassingMaze({ corridor, page, opened }: Opened): Promise<void> {
  await opened.card.getByText("Unseen mazes that pass: 20").click();
  const list = opened.card.getByRole("list", { name: "Unseen mazes that pass" });
  await expectNoAxeViolations(page, "a check without failures");
  await list.getByRole("button", { name: "Tree 20 of seed 7" }).click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Tree 20 of seed 7, Maze menu");
  await expect(corridor.message(/^Tree 20 of seed 7: passes in \d+\.\d s/)).toBeVisible();
  await expect(corridor.robotPose).toHaveText("Robot at 150, 150, facing down");
  await page.getByRole("button", { name: "Watch", exact: true }).click();
  await expect(corridor.robotPose).toHaveText("Robot at 575, 752, facing left");
  await page.getByRole("button", { name: "Back to the task" }).click();
  await opened.expectTask(1);
}

/** Plays the last seconds before a failure, and goes back to the task. */
async function watchFailures({ corridor, page, opened }: Opened): Promise<void> {
  const all = opened.card.getByText("All mazes that do not pass: 20");
  await all.click();
  const list = opened.card.getByRole("list", { name: "Mazes that do not pass" });
  const last = list.getByRole("button").last();
  const name = (await last.textContent()) ?? "";
  expect(name).toMatch(/^Tree \d+ of seed 7$/);
  await expectNoAxeViolations(page, "a check with failures");
  await last.click();
  await expect(corridor.mazeMenu).toHaveAccessibleName(`${name}, Maze menu`);
  await expect(corridor.message(/bump at/)).toBeVisible();
  await expect(corridor.bumps).toHaveText("1 bump");
  await expect(opened.card).toBeHidden();
  await page.getByRole("button", { name: "Back to the task" }).click();
  await opened.expectTask(1);
  // The result is still there: the next failure needs no second check.
  await expect(all).toBeVisible();
  await opened.card.getByRole("button", { name: "Watch" }).click();
  await expect(corridor.bumps).toHaveText("1 bump");
  await page.getByRole("button", { name: "Back to the task" }).click();
  await opened.expectTask(1);
}

async function stopCheck({ corridor, page, opened }: Opened): Promise<void> {
  const unseen = { kind: "tree", columns: 33, rows: 33, seed: 7, count: 1_000, pass: 1 } as const;
  const checks = { bumps: null, seconds: 3_600 };
  await drop(page, { ...lesson, tasks: [taskOf("Many", { unseen, checks }), taskOf("Two")] });
  await expect(opened.card).toContainText("Solve Many.");
  await corridor.program.addLine("front <", "50", "turn 180");
  await opened.card.getByRole("button", { name: "Check in all 1,001 mazes" }).click();
  await expect(opened.card.getByText(/^Checking [1-9]\d* of 1,001\.$/)).toBeVisible();
  const stop = opened.card.getByRole("button", { name: "Stop" });
  await stop.click();
  await expect(opened.card).toContainText(/Stopped after \d+ of 1,001\./);
  await expect(opened.card.getByRole("button", { name: /^Check in all/ })).toBeFocused();
}

async function missGoal({ corridor, page, opened }: Opened): Promise<void> {
  const checks = { bumps: 0, seconds: 2 };
  await drop(page, { ...lesson, tasks: [taskOf("Slow", { checks, mazes: [straight, side] })] });
  const { card } = new LessonsPanel(page);
  await expect(card).toContainText("Solve Slow.");
  await card.getByRole("button", { name: "Check in both mazes" }).click();
  await expect(card.getByRole("note")).toHaveText(
    "Maze 1: Goal not reached in 2 s. More time may be enough.",
  );
  await corridor.speed.selectOption("16×");
  await corridor.run.click();
  await expect(card.getByRole("note")).toHaveText(
    "Goal not reached in 2 s. More time may be enough.",
  );
  await expect(opened.card).toBeHidden();
}
