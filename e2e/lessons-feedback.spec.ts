/**
 * What a student reads after the typical wrong answer to a mission: what went wrong, where, what to
 * try.
 */
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { waitForAnimations } from "./support/wait-for-animations.ts";

interface WrongAnswer {
  mission: number;
  /** as a student would do it with the editor */
  make: (corridor: CorridorPage) => Promise<unknown>;
  reads: RegExp;
}

const asGiven = async () => {};

const wrongAnswers: readonly WrongAnswer[] = [
  {
    mission: 3,
    make: ({ program }) => program.action(1).selectOption("reverse"),
    reads: /Line 1 drives back and “otherwise” drives forward, again and again\. .* Try a turn\.$/,
  },
  {
    mission: 4,
    make: asGiven,
    reads:
      /Line 2 was true .*front: 49\.99 cm.* line 1 above it decided\. The first true line wins\.$/,
  },
  {
    mission: 5,
    make: ({ program }) => program.number(1).fill("4"),
    reads: /Line 1 is always true\. No sensor reads less than 25 cm\. One block is 100 cm\.$/,
  },
  {
    mission: 6,
    make: ({ program }) => program.addLine("front >", "50", "right 90"),
    reads: /^Bump .* Line 1 was true .*front: 450 cm.* Its sign, “>”, points the wrong way\.$/,
  },
  {
    mission: 7,
    make: ({ program }) => program.action(1).selectOption("right 90"),
    reads:
      /^Bump .* Line 1 chose “right 90” .*right: 250 cm.* A delayed turn drives on for 50 cm first\.$/,
  },
  {
    mission: 9,
    make: asGiven,
    reads:
      /Line 2 was true .*right: 250 cm.* line 1 above it decided\. The first true line wins\.$/,
  },
  {
    mission: 10,
    make: asGiven,
    reads:
      /^Bump .* Line 3 chose “delayed left 90” at 6\.\d s with 49\.99 cm in front\. .* needs 75 cm\.$/,
  },
  {
    mission: 13,
    make: async ({ program }) => {
      await program.action(2).selectOption("left 90");
      await program.otherwise.selectOption("left 90");
    },
    reads:
      /Maze 2: .*“otherwise” chose “left 90” .*left: 150 cm, right: 250 cm.* It needs another action\.$/,
  },
];

const delayedLeft = ({ program }: CorridorPage) =>
  program.action(1).selectOption("delayed left 90");

function wrongAnswerTo(mission: number): WrongAnswer["make"] {
  return wrongAnswers.find((each) => each.mission === mission)?.make ?? asGiven;
}

for (const { mission, make, reads } of wrongAnswers) {
  test(`mission ${mission}: the typical wrong answer is told its line and its numbers`, async ({
    corridor,
    page,
  }) => {
    const lessons = new LessonsPanel(page);
    await lessons.openMission(mission);
    await make(corridor);
    const check = lessons.button(/^Check in (all|both)/);
    if ((await check.count()) > 0) await check.click();
    else {
      await corridor.speed.selectOption("max");
      await corridor.run.click();
    }
    await expect(lessons.outcome).toHaveText(reads);
    // Nothing asks to skip what is not solved yet.
    await expect(lessons.button("Next mission")).toHaveCount(0);
  });
}

test("the card at the dead end of mission 10 leads to the line that has to change", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(10);
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const card = corridor.bumpCard(3);
  // The student finds the change: no button makes it.
  await expect(card.getByRole("button", { name: /^Change/ })).toHaveCount(0);
  await card.getByRole("button", { name: "Show line 3" }).click();
  await expect(corridor.program.line(3)).toBeFocused();
  await expect(corridor.program.line(3)).toBeInViewport({ ratio: 1 });
  await corridor.program.action(3).selectOption("turn 180");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText("Challenge solved. Lines used: 3 of 3");
});

const sizes = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
];

for (const viewport of sizes) {
  test(`the task, both lines, otherwise and Run are in sight at ${viewport.width} x ${viewport.height}`, async ({
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

for (const { mission, make, goal } of [
  { mission: 6, make: wrongAnswerTo(6), goal: { column: 5, row: 3 } },
  { mission: 7, make: wrongAnswerTo(7), goal: { column: 3, row: 3 } },
  { mission: 8, make: delayedLeft, goal: { column: 5, row: 1 } },
]) {
  test(`mission ${mission}: the card at the bump leaves the robot and the goal in sight`, async ({
    openWindow,
  }) => {
    const corridor = await openWindow({ viewport: { width: 1024, height: 768 } });
    await corridor.open();
    const { page, maze } = corridor;
    await new LessonsPanel(page).openMission(mission);
    await make(corridor);
    await corridor.speed.selectOption("16×");
    await corridor.run.click();
    const card = page.getByRole("region", { name: /^Bump: / });
    await expect(card).toBeVisible();
    await waitForAnimations(page);
    const shown = await card.evaluate((element) => element.getBoundingClientRect().toJSON());
    const place = (await corridor.robotPose.textContent()) ?? "";
    const [x = 0, y = 0] = (place.match(/\d+/g) ?? []).map(Number);
    for (const box of [await maze.squareBox(goal), await maze.robotBox(x, y)]) {
      const isApart =
        box.x + box.side < shown.left ||
        box.x > shown.right ||
        box.y + box.side < shown.top ||
        box.y > shown.bottom;
      expect(isApart).toBe(true);
    }
  });
}

test("on a phone the task folds away, and both lines stand above the edge with Run", async ({
  openWindow,
}) => {
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
