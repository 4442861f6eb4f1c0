/**
 * An attempt at a mission: what the user may change, when it is solved, and the feedback until
 * then.
 */
import type { Page } from "playwright/test";
import { lessonOfTasks } from "@corridor/challenge/testing";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { drop } from "./pages/lesson-card.ts";
import { driveToWall } from "./support/drive-to-wall.ts";
import { lessonTask, straight } from "./support/lesson-task.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";

test.use(smallWindow);

interface OpenPage {
  corridor: CorridorPage;
  page: Page;
  lessons: LessonsPanel;
}

test("reports what failed, and solves missions for the program and for manual driving, whose card covers no robot", async ({
  corridor,
  page,
}) => {
  const open: OpenPage = { corridor, page, lessons: new LessonsPanel(page) };
  await test.step("reports what failed, with the number, while the robot drives", () =>
    failAndSolve(open));
  await test.step("reports that a mission for the program excludes manual driving, and why a run that reaches the goal does not count", () =>
    bumpToGoal(open));
  await page.setViewportSize({ width: 1024, height: 768 });
  await test.step("disables Run in a mission for manual driving, which is solved when the key is released at the required reading", () =>
    driveByHand(open));
  await test.step("does not cover the robot with the card of a mission at 1024 x 768", async () => {
    await corridor.reset.click();
    await corridor.program.action(1).selectOption("turn 180");
    await corridor.speed.selectOption("max");
    await corridor.run.click();
    await expect(page.getByRole("region", { name: "Solved!" })).toBeVisible();
    expect(await overlapOf(open), "mission 3").toBe(0);
  });
  await test.step("solves a task of two mazes by hand, one after the other", () =>
    driveInTwoMazes(open));
});

async function failAndSolve({ corridor, lessons }: OpenPage): Promise<void> {
  await lessons.openMission(8);
  await corridor.program.action(1).selectOption("delayed left 90");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText(
    /^Bump at 4\.\d s\. Line 1 chose “delayed left 90” at 4\.\d s with 49\.99 cm in front\. .* needs 75 cm\.$/,
  );
  await corridor.program.action(1).selectOption("left 90");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText("Task solved. Lines used: 1 of 1");
}

async function bumpToGoal({ corridor, page, lessons }: OpenPage): Promise<void> {
  await lessons.openMission(3);
  // The mission has its own check.
  await expect(corridor.program.button("Try it in other mazes")).toHaveCount(0);
  const start = await corridor.robotPose.textContent();
  await page.keyboard.press("w", { delay: 120 });
  await expect(corridor.messages).toContainText("You cannot drive by hand here.");
  await expect(corridor.robotPose).toHaveText(start ?? "");
  await expect(corridor.driver("Program")).toHaveCount(0);
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(lessons.outcome).toContainText(/^Bump at/);
  await corridor.program.action(1).selectOption("left 90");
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText(
    /^Bump at \d\.\d s\. No bumps are allowed here\. Press Reset and try again\.$/,
  );
  await expect(page.getByRole("region", { name: "Solved!" })).toBeHidden();
}

async function driveByHand(open: OpenPage): Promise<void> {
  const { corridor, page, lessons } = open;
  await lessons.openMission(2);
  await expect(corridor.run).toBeDisabled();
  await expect(corridor.runNote).toHaveText("You drive here. Hold a drive key.");
  // Only one driver is allowed, so there is nothing to choose.
  await expect(corridor.driver("Me")).toHaveCount(0);
  await corridor.reset.click();
  await expect(corridor.clock).toHaveText("Time 0:00.0");
  await page.keyboard.press("w", { delay: 400 });
  await expect(lessons.outcome).toHaveText(
    /^The sensor reads [56]\d\d cm\. Drive forward until it reads 130 to 170 cm\.$/,
  );
  await driveToWall(corridor, 130, 170);
  await expect(lessons.outcome).toHaveText(/^Task solved after \d\.\d s$/);
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved).toContainText(/^Solved!The robot stopped where the sensor reads 1\d\d cm\./);
  expect(await overlapOf(open), "mission 2").toBe(0);
  await solved.getByRole("button", { name: "Next mission" }).click();
  await lessons.expectMission(3);
}

async function driveInTwoMazes({ corridor, page, lessons }: OpenPage): Promise<void> {
  const second = { ...straight, blocks: ["#######", "#.....#", "#.#####", "#######"] };
  const { allowed, ...task } = lessonTask("Two mazes", [], { mazes: [straight, second] });
  await drop(
    page,
    lessonOfTasks("By hand", [{ ...task, allowed: { ...allowed, drivers: ["me", "program"] } }]),
  );
  const { card, outcome } = lessons;
  await expect(card).toContainText("Solve Two mazes.");
  await driveToWall(corridor, 35, 70);
  await expect(outcome).toHaveText("Reached in 1 of 2 mazes. Drive in the others too.");
  await page.getByRole("region", { name: "Works in this maze." }).getByText("Maze 2").click();
  await expect(card.getByRole("button", { name: "Maze 2" })).toHaveAttribute(
    "aria-pressed",
    "true",
  );
  // The readings of the other maze are displayed until then.
  await expect(corridor.robotPose).toHaveText("Robot at 150, 150, facing right");
  await driveToWall(corridor, 35, 70);
  await expect(outcome).toHaveText(/^Task solved after/);
  await expect(card).toContainText("There is no code: this task has several mazes");
}

/** The area of the robot that the card of a solved mission covers, in square pixels. */
async function overlapOf({ corridor, page }: OpenPage): Promise<number> {
  const card = page.getByRole("region", { name: "Solved!" });
  await waitForAnimations(page);
  const pose = (await corridor.robotPose.textContent()) ?? "";
  const [x = 0, y = 0] = pose.match(/\d+/g)?.map(Number) ?? [];
  const robot = await corridor.maze.robotBox(x, y);
  const box = await card.boundingBox();
  if (box === null) throw new Error("there is no card");
  const width = Math.min(robot.x + robot.side, box.x + box.width) - Math.max(robot.x, box.x);
  const height = Math.min(robot.y + robot.side, box.y + box.height) - Math.max(robot.y, box.y);
  return Math.max(0, width) * Math.max(0, height);
}

test("reports which maze fails, offers only what the mission allows, restarts it, and announces nothing once it is closed", async ({
  corridor,
  page,
}) => {
  const open: OpenPage = { corridor, page, lessons: new LessonsPanel(page) };
  await test.step("restarts a mission, and mentions the program only if one was removed", () =>
    restart(open));
  await test.step("offers only what the mission allows in the menus", () => readMenus(open));
  await test.step("reports which maze fails, in place of the earlier verdict", () =>
    checkAll(open));
  await test.step("announces nothing of a mission that is no longer open", () =>
    closeMission(open));
});

async function restart({ corridor, lessons }: OpenPage): Promise<void> {
  await lessons.openMission(6);
  await lessons.button("Restart").click();
  await expect(corridor.messages).toContainText("The mission starts again.");
  await expect(corridor.messages).not.toContainText("program");
  await corridor.messages.getByRole("button", { name: "Dismiss" }).click();

  await corridor.program.button("Add line").click();
  await lessons.button("Restart").click();
  await expect(corridor.program.lines).toHaveCount(0);
  await expect(corridor.messages).toContainText("Your program was removed.");
  await corridor.messages.getByRole("button", { name: "Undo" }).click();
  await expect(corridor.program.lines).toHaveCount(1);

  // Undo of one mission is not offered in another.
  await lessons.button("Restart").click();
  await expect(corridor.messages).toContainText("Your program was removed.");
  await lessons.openMission(7);
  await expect(corridor.messages).not.toContainText("Your program was removed.");
}

async function readMenus({ corridor, lessons }: OpenPage): Promise<void> {
  // Only the action can be selected, from four.
  await lessons.openMission(3);
  await expect(corridor.program.action(1).getByRole("option")).toHaveText([
    "forward",
    "reverse",
    "left 90",
    "turn 180",
  ]);
  await expect(corridor.program.condition(1)).toBeDisabled();
  await expect(corridor.program.number(1)).toBeDisabled();
  // Fixed values are plain text, without the border of a field.
  for (const fixed of [corridor.program.condition(1), corridor.program.number(1)]) {
    await expect(fixed).toHaveCSS("border-top-color", "rgba(0, 0, 0, 0)");
  }
  // A note replaces the unusable button.
  await expect(corridor.program.button("Add line")).toHaveCount(0);
  await expect(corridor.program.region).toContainText("You cannot add lines here.");
  // Only the number can be changed.
  await lessons.openMission(5);
  await expect(corridor.program.action(1)).toBeDisabled();
  await expect(corridor.program.number(1)).toBeEnabled();
  // One line, with front as its only sensor.
  await lessons.openMission(6);
  await corridor.program.button("Add line").click();
  await expect(corridor.program.condition(1).getByRole("option")).toHaveText([
    "choose a condition",
    "front >",
    "front <",
  ]);
  await expect(corridor.program.button("Add line")).toBeDisabled();
  await expect(corridor.program.button("Add line")).toHaveAccessibleDescription(
    "You can use 1 line here. “Otherwise” does not count.",
  );
  // The maze is fixed, and a message reports it.
  await corridor.maze.click({ column: 3, row: 1 });
  await expect(corridor.message(/You cannot change this maze/)).toBeVisible();
  await corridor.maze.expectSquare({ column: 3, row: 1 }, "open");
}

async function checkAll({ corridor, page, lessons }: OpenPage): Promise<void> {
  await lessons.openMission(12);
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const part = page.getByRole("region", { name: "Works in this maze. Now check all 3." });
  await part.getByRole("button", { name: "Check in all 3 mazes" }).click();
  await expect(part).toBeHidden();
  await expect(lessons.outcome).toHaveText(/^Maze 2: The goal was not reached in 40 s/);
  await expect(lessons.card).toContainText("Passes in 1 of 3.");
  await expect(page.getByText(/Works in this maze|Solved!/)).toHaveCount(0);
  await expect(page.getByRole("button", { name: "Next mission" })).toHaveCount(0);
  await lessons.button("Watch").click();
  await expect(lessons.button("Maze 2: does not work yet")).toHaveAttribute("aria-pressed", "true");
  await corridor.maze.expectSquare({ column: 5, row: 3 }, "open, goal");
  // The right-wall program passes in all of them.
  await corridor.program.addLine("right >", "60", "delayed right 90");
  await lessons.button("Check in all 3 mazes").click();
  await expect(lessons.outcome).toHaveText("Task solved. Lines used: 2 of 3");
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved).toContainText("Your program works in every maze: 3 of 3.");
  // The clock displays only the run in one of the mazes.
  await expect(solved).toContainText("longest run time");
  await expect(solved.getByRole("button", { name: "Next mission" })).toBeVisible();
  await expect(page.getByRole("button", { name: "Next mission" })).toHaveCount(1);
}

async function closeMission({ corridor, lessons }: OpenPage): Promise<void> {
  await lessons.openMission(12);
  await lessons.button(/^Check in (all|both)/).click();
  await expect(lessons.outcome).not.toBeEmpty();
  const outcome = (await lessons.outcome.textContent()) ?? "";
  await expect(corridor.announcement).toHaveText(outcome);
  await lessons.button("Back to my maze").click();
  await expect(lessons.card).toBeHidden();
  await expect(corridor.announcement).not.toContainText(outcome);
}

test("judges a run although the network was lost while the mission opened", async ({
  corridor,
  page,
  pageErrors,
}) => {
  let isDown = true;
  let requests = 0;
  await page.route(/run-judge/, (route) => {
    requests += 1;
    return isDown ? route.abort() : route.continue();
  });
  const lessons = new LessonsPanel(page);
  await lessons.openMission(8);
  await expect.poll(() => requests).toBeGreaterThan(0);
  await corridor.program.action(1).selectOption("left 90");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect.poll(() => requests).toBeGreaterThan(1);
  isDown = false;
  await expect(lessons.outcome).toHaveText("Task solved. Lines used: 1 of 1");
  // The browser logs an error for each missing file.
  pageErrors.messages.splice(0);
});
