/**
 * The bonus missions, and the certificate of a student who has solved them all.
 */
import { readFile } from "node:fs/promises";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { MazeGrid } from "./pages/maze-grid.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

test("has missions for a program in all mazes, a maze that defeats a program, and driving by hand", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);

  await test.step("checks a program in all preset mazes as it changes, and stores the best result", async () => {
    await corridor.open("/#mission/all-mazes");
    await expect(lessons.card).toContainText("Bonus mission 1 of 3");
    await expect(lessons.outcome).toHaveText(/^Solved: 1 of 7 mazes/);
    await corridor.program.addLine("right >", "60", "delayed right 90");
    await corridor.program.addLine("front <", "50", "left 90");
    await expect(lessons.outcome).toHaveText(/^Solved: 7 of 7 mazes/);
    await expect(lessons.card).toContainText(/Your best: 7 of 7 mazes, \d+\.\d s/);
    await lessons.openPath();
    const project = lessons.path.getByRole("button", { name: /^One program, all mazes/ });
    await expect(project).toContainText("Your best: 7 of 7 mazes");
    await expectNoAxeViolations(page, "bonus missions");
    await page.keyboard.press("Escape");
  });

  await test.step("accepts a maze that defeats the right-wall program", async () => {
    await corridor.open("/#mission/beat-right-wall");
    await expect(corridor.program.region).toContainText("You cannot add lines here.");
    await expect(lessons.outcome).toHaveText(/^The program reaches the goal after \d+\.\d s\./);
    // Reaching the goal does not solve this project.
    await corridor.speed.selectOption("max");
    await corridor.run.click();
    await corridor.waitForRobotToStop();
    await expect(page.getByRole("region", { name: "Solved!" })).toBeHidden();
    const maze = new MazeGrid(page);
    await corridor.reset.click();
    await maze.tool("Goal").check();
    await maze.click({ column: 4, row: 2 });
    await maze.click({ column: 7, row: 1 });
    await expect(lessons.outcome).toHaveText(
      "Your maze wins: the program does not reach the goal in 300 s. Open squares: 21.",
    );
    await page.reload();
    await expect(lessons.card).toContainText("Your best: open squares 21");
  });

  await test.step("offers no program for manual driving", async () => {
    await corridor.open("/#mission/fewest-bumps");
    await expect(lessons.card).toContainText("Careful driving");
    await expect(corridor.run).toBeDisabled();
    await expect(page.getByRole("button", { name: "Step", exact: true })).toBeDisabled();
    await page.keyboard.press("Control+Enter");
    await page.keyboard.press("Control+Shift+Enter");
    await expect(corridor.clock).toHaveText("Time 0:00.0");
    await page.keyboard.down("w");
    await expect(corridor.clock).not.toHaveText("Time 0:00.0");
    await page.keyboard.up("w");
  });
});

test("offers a certificate on the card of the mission that completes all of them", async ({
  page,
}) => {
  // A document of the same origin, without scripts.
  await page.goto("/robots.txt");
  await page.evaluate(() => {
    const ids =
      "make-it-move how-far first-true-line centimetres own-line side-opening no-room " +
      "order-of-lines faulty-line right-wall every-maze left-or-right farthest-distance";
    const done = Object.fromEntries(ids.split(" ").map((id) => [id, { lines: 2, ticks: 600 }]));
    localStorage.setItem("corridor.lessons", JSON.stringify({ done, works: {}, home: null }));
  });
  const corridor = new CorridorPage(page);
  await corridor.open();
  const lessons = new LessonsPanel(page);
  await lessons.openMission(3);
  await corridor.program.action(1).selectOption("turn 180");
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  const solved = page.getByRole("region", { name: "Solved!" });
  // One line is not "1 lines".
  await expect(solved.getByRole("term").filter({ hasText: /^line(?!s)/ })).toBeVisible();
  await solved.getByRole("button", { name: "Save your picture" }).click();
  const finish = lessons.path.getByRole("region", { name: "All 14 missions done" });
  const picture = finish.getByRole("img");
  await expect(picture).toHaveAccessibleName(
    /^All 14 missions done, .+ 20\d\d\. Lines written: 27 · Driving time: 2:\d\d/,
  );
  await expectNoAxeViolations(page, "the finish");
  const saving = page.waitForEvent("download");
  await finish.getByRole("button", { name: "Save as SVG" }).click();
  const file = await (await saving).path();
  const svg = await readFile(file, "utf8");
  expect(svg).toContain(">All 14 missions done</text>");
  const [result = "no result"] = /Lines written: 27 · Driving time: 2:\d\d\.\d/.exec(svg) ?? [];
  expect(svg).toContain(`>${result}</text>`);
  await expect(picture).toHaveAccessibleName(new RegExp(result));
});
