/**
 * Feedback on typical wrong answers to missions: what went wrong, where, and what to try.
 */
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";

interface WrongAnswer {
  mission: number;
  /** enters the answer in the editor, as a student does */
  enter: (corridor: CorridorPage) => Promise<unknown>;
  feedback: RegExp;
}

const unchanged = async () => {};

const wrongAnswers: readonly WrongAnswer[] = [
  {
    mission: 3,
    enter: ({ program }) => program.action(1).selectOption("reverse"),
    feedback:
      /Line 1 drives back and “otherwise” drives forward, again and again\. .* Try a turn\.$/,
  },
  {
    mission: 4,
    enter: unchanged,
    feedback:
      /Line 2 was true .*front: 49\.99 cm.* line 1 above it decided\. The first true line wins\.$/,
  },
  {
    mission: 5,
    enter: ({ program }) => program.number(1).fill("4"),
    feedback: /Line 1 is always true\. No sensor reads less than 25 cm\. One block is 100 cm\.$/,
  },
  {
    mission: 6,
    enter: ({ program }) => program.addLine("front >", "50", "right 90"),
    feedback: /^Bump .* Line 1 was true .*front: 450 cm.* Its sign, “>”, points the wrong way\.$/,
  },
  {
    mission: 7,
    enter: ({ program }) => program.action(1).selectOption("right 90"),
    feedback:
      /^Bump .* Line 1 chose “right 90” .*right: 250 cm.* A delayed turn drives on for 50 cm first\.$/,
  },
  {
    mission: 9,
    enter: unchanged,
    feedback:
      /Line 2 was true .*right: 250 cm.* line 1 above it decided\. The first true line wins\.$/,
  },
  {
    mission: 10,
    enter: unchanged,
    feedback:
      /^Bump .* Line 3 chose “delayed left 90” at 6\.\d s with 49\.99 cm in front\. .* needs 75 cm\.$/,
  },
  {
    mission: 13,
    enter: async ({ program }) => {
      await program.action(2).selectOption("left 90");
      await program.otherwise.selectOption("left 90");
    },
    feedback:
      /Maze 2: .*“otherwise” chose “left 90” .*left: 150 cm, right: 250 cm.* It needs another action\.$/,
  },
];

const delayedLeft = ({ program }: CorridorPage) =>
  program.action(1).selectOption("delayed left 90");

function wrongAnswerTo(mission: number): WrongAnswer["enter"] {
  return wrongAnswers.find((each) => each.mission === mission)?.enter ?? unchanged;
}

for (const { mission, enter, feedback } of wrongAnswers) {
  test(`mission ${mission}: the feedback on the typical wrong answer names its line and numbers`, async ({
    corridor,
    page,
  }) => {
    const lessons = new LessonsPanel(page);
    await lessons.openMission(mission);
    await enter(corridor);
    const check = lessons.button(/^Check in (all|both)/);
    if ((await check.count()) > 0) await check.click();
    else {
      await corridor.speed.selectOption("max");
      await corridor.run.click();
    }
    await expect(lessons.outcome).toHaveText(feedback);
    // An unsolved mission does not offer the next one.
    await expect(lessons.button("Next mission")).toHaveCount(0);
  });
}

test("the card at the dead end of mission 10 leads to the line that must change", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(10);
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const card = corridor.bumpCard(3);
  // The student must find the fix: no button applies it.
  await expect(card.getByRole("button", { name: /^Change/ })).toHaveCount(0);
  await card.getByRole("button", { name: "Show line 3" }).click();
  await expect(corridor.program.line(3)).toBeFocused();
  await expect(corridor.program.line(3)).toBeInViewport({ ratio: 1 });
  await corridor.program.action(3).selectOption("turn 180");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText("Task solved. Lines used: 3 of 3");
});

test("mission 11 without a bump: names the line that lacks its delay, though another is wrong too", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(11);
  await corridor.program.addLine("right >", "60", "right 90");
  await corridor.program.addLine("front <", "50", "turn 180");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText(
    /^Time is up after 60 s\. Line 1 chose “right 90” at 1\.5 s, at the edge of the opening/,
  );
});

test("shows the room that a turn needs only beside a sentence about that turn", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(10);
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.bumpCard(3)).toContainText("Needed, from the robot’s middle");
  // Now line 2 drives into the wall, with a delayed turn that line 3 has led to.
  await corridor.program.action(3).selectOption("left 90");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(corridor.bumpCard(3)).toContainText("Line 3 chose “left 90”");
  await expect(corridor.bumpCard(3)).not.toContainText("Needed");
});

const sizes = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
];

for (const viewport of sizes) {
  test(`shows the task, both lines, otherwise and Run at ${viewport.width} x ${viewport.height}`, async ({
    openWindow,
  }) => {
    const corridor = await openWindow({ viewport });
    await corridor.open();
    const lessons = new LessonsPanel(corridor.page);
    for (const mission of [4, 9]) {
      await lessons.openMission(mission);
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
  });
}

for (const { mission, enter, goal } of [
  { mission: 6, enter: wrongAnswerTo(6), goal: { column: 5, row: 3 } },
  { mission: 7, enter: wrongAnswerTo(7), goal: { column: 3, row: 3 } },
  { mission: 8, enter: delayedLeft, goal: { column: 5, row: 1 } },
]) {
  test(`mission ${mission}: the bump card covers neither the robot nor the goal`, async ({
    openWindow,
  }) => {
    const corridor = await openWindow({ viewport: { width: 1024, height: 768 } });
    await corridor.open();
    const { page, maze } = corridor;
    await new LessonsPanel(page).openMission(mission);
    await enter(corridor);
    await corridor.speed.selectOption("16×");
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
      expect(isApart).toBe(true);
    }
  });
}

test("on a phone the task can be hidden, and both lines fit above Run", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 390, height: 844 } });
  await corridor.open();
  const lessons = new LessonsPanel(corridor.page);
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
});
