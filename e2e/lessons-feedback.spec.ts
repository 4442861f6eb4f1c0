/**
 * Feedback on typical wrong answers to missions: what went wrong, where, and what to try. The
 * sentences of all missions are in feedback.exhaustive.test.ts.
 */
import type { Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { smallWindow } from "./support/window-sizes.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";

test.use(smallWindow);

test("the feedback on a typical wrong answer names its line and numbers, and leads to the line that must change", async ({
  corridor,
  page,
}) => {
  const open: OpenPage = { corridor, page, lessons: new LessonsPanel(page) };
  await corridor.speed.selectOption("max");
  await page.setViewportSize({ width: 1024, height: 768 });
  await test.step("the bump card covers neither the robot nor the goal", () => bumpThrice(open));
  await page.setViewportSize(smallWindow.viewport);
  await test.step("the feedback on a check of all mazes", () => checkBoth(open));
  await test.step("the card at the dead end of mission 10 leads to the line that must change", () =>
    fixLine(open));
  await test.step("shows the task, both lines, otherwise and Run at 1440 x 900 and 1024 x 768", () =>
    showAll(open));
  await page.setViewportSize({ width: 390, height: 844 });
  await test.step("on a phone the task can be hidden, and both lines fit above Run", () =>
    hideTask(open));
});

interface OpenPage {
  corridor: CorridorPage;
  page: Page;
  lessons: LessonsPanel;
}

/** Runs typical wrong answers to three missions. */
async function bumpThrice({ corridor, page, lessons }: OpenPage): Promise<void> {
  const { maze, program } = corridor;
  for (const { mission, enter, goal } of [
    {
      mission: 6,
      enter: () => program.addLine("front >", "50", "right 90"),
      goal: { column: 5, row: 3 },
    },
    {
      mission: 7,
      enter: () => program.action(1).selectOption("right 90"),
      goal: { column: 3, row: 3 },
    },
    {
      mission: 8,
      enter: () => program.action(1).selectOption("delayed left 90"),
      goal: { column: 5, row: 1 },
    },
  ]) {
    await lessons.openMission(mission);
    await enter();
    await corridor.run.click();
    const card = page.getByRole("region", { name: /^Bump: / });
    await expect(card).toBeVisible();
    await waitForAnimations(page);
    const cardBox = await card.evaluate((element) => element.getBoundingClientRect().toJSON());
    const pose = (await corridor.robotPose.textContent()) ?? "";
    const [x = 0, y = 0] = (pose.match(/\d+/g) ?? []).map(Number);
    for (const box of [await maze.squareBox(goal), await maze.robotBox(x, y)]) {
      const isApart =
        box.x + box.side < cardBox.left ||
        box.x > cardBox.right ||
        box.y + box.side < cardBox.top ||
        box.y > cardBox.bottom;
      expect(isApart, `mission ${mission}`).toBe(true);
    }
    if (mission === 6) {
      await expect(lessons.outcome).toHaveText(
        /^Bump .* Line 1 was true .*front: 450 cm.* Its sign, “>”, points the wrong way\.$/,
      );
      // An unsolved mission does not offer the next one.
      await expect(lessons.button("Next mission")).toHaveCount(0);
    }
  }
}

async function checkBoth({ corridor: { program }, lessons }: OpenPage): Promise<void> {
  await lessons.openMission(13);
  await program.action(2).selectOption("left 90");
  await program.otherwise.selectOption("left 90");
  await lessons.button("Check in both mazes").click();
  await expect(lessons.outcome).toHaveText(
    /Maze 2: .*“otherwise” chose “left 90” .*left: 150 cm, right: 250 cm.* It needs another action\.$/,
  );
  await expect(lessons.button("Next mission")).toHaveCount(0);
}

async function fixLine({ corridor, lessons }: OpenPage): Promise<void> {
  const { program } = corridor;
  await lessons.openMission(10);
  await corridor.run.click();
  const card = corridor.bumpCard(3);
  await expect(card).toContainText("Needed, from the robot’s middle");
  // The student must find the fix: no button applies it.
  await expect(card.getByRole("button", { name: /^Change/ })).toHaveCount(0);
  await card.getByRole("button", { name: "Show line 3" }).click();
  await expect(program.line(3)).toBeFocused();
  await expect(program.line(3)).toBeInViewport({ ratio: 1 });
  // Now line 2 drives into the wall, with a delayed turn that line 3 has led to. The needed room is
  // shown only beside a sentence about the turn that needs it.
  await program.action(3).selectOption("left 90");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(card).toContainText("Line 3 chose “left 90”");
  await expect(card).not.toContainText("Needed");
  await program.action(3).selectOption("turn 180");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText("Task solved. Lines used: 3 of 3");
}

async function showAll({ corridor, page, lessons }: OpenPage): Promise<void> {
  for (const mission of [4, 9]) {
    await lessons.openMission(mission);
    for (const [width, height] of [
      [1440, 900],
      [1024, 768],
    ] as const) {
      await page.setViewportSize({ width, height });
      for (const part of [
        lessons.card,
        corridor.program.line(1),
        corridor.program.line(2),
        corridor.program.otherwise,
        corridor.run,
      ]) {
        await expect(part).toBeInViewport({ ratio: 1 });
      }
    }
  }
}

async function hideTask({ corridor, lessons }: OpenPage): Promise<void> {
  await lessons.openMissionOnPhone(4);
  const task = lessons.card.getByText("Both lines are true at the wall");
  await expect(task).toBeVisible();
  await lessons.button("Hide the task").click();
  await expect(task).toBeHidden();
  for (const part of [
    corridor.run,
    corridor.program.line(1),
    corridor.program.line(2),
    corridor.program.otherwise,
  ]) {
    await expect(part).toBeInViewport({ ratio: 1 });
  }
  await lessons.button("Show the task").click();
  await expect(task).toBeVisible();
}
