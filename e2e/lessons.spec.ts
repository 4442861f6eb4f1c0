/** A new student, who reads nothing but what stands on the stage and in the panel. */
import type { ChallengeDocument } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import { expect, test } from "./fixtures.ts";
import { CorridorPage } from "./pages/corridor-page.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { expectNoBarriers } from "./support/axe.ts";
import { atRest } from "./support/at-rest.ts";
import { stickingOut } from "./support/layout.ts";

test("a new student solves the first mission within a minute of the first visit", async ({
  corridor,
  page,
}) => {
  const lessons = new LessonsPanel(page);
  // Two actions: one press on what is offered, and one key held. The robot needs 4 s of simulated time.
  await lessons.invitation.getByRole("button", { name: "Start with mission 1" }).click();
  await lessons.expectMission(1);
  await expect(corridor.driver("Me")).toBeChecked();
  await page.keyboard.down("w");
  await expect(lessons.outcome).toHaveText(/^Challenge met after \d\.\d s$/);
  await page.keyboard.up("w");
  await expect(page.getByRole("main").getByText(/^Challenge met after/)).toBeVisible();
  await lessons.button("Next mission").click();
  await lessons.expectMission(2);
});

test("a new student who presses Run first has made it move too", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await lessons.invitation.getByRole("button", { name: "Start with mission 1" }).click();
  await lessons.expectMission(1);
  await corridor.run.click();
  // There is no line to count here.
  await expect(lessons.outcome).toHaveText(/^Challenge met after \d\.\d s$/);
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved.getByRole("term")).toHaveText(["run time", "bumps"]);
  await solved.getByRole("button", { name: "Next mission" }).click();
  await lessons.expectMission(2);
});

test("says no to the invitation and is not asked again", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await lessons.invitation.getByRole("button", { name: "Not now" }).click();
  await expect(lessons.invitation).toBeHidden();
  await corridor.open();
  await expect(lessons.invitation).toBeHidden();
});

test("keeps progress after a reload", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(3);
  await corridor.program.action(1).selectOption("turn 180");
  await corridor.speed.selectOption("16×");
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText("Challenge met: 1 of 1 lines used");
  await corridor.open();
  await lessons.expectMission(3);
  await expect(corridor.program.action(1)).toHaveValue("turn 180");
  await lessons.openPath();
  await expect(lessons.path.getByRole("button", { name: /^3\. / })).toContainText("Done");
  await expect(lessons.path).toContainText("1 of 14 done");
  await lessons.path.getByRole("button", { name: "Forget my progress" }).click();
  await expect(lessons.path).toContainText("0 of 14 done");
});

test("comes back to a mission of the hand and drives on by the keyboard", async ({
  corridor,
  page,
  context,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(2);
  await corridor.reload();
  await lessons.expectMission(2);
  await expect(corridor.driver("Me")).toBeChecked();
  // The same on another day, in another tab, and from the list of mazes.
  const other = new CorridorPage(await context.newPage());
  await other.open();
  await expect(other.driver("Me")).toBeChecked();
  await other.mazeMenu.click();
  await other.page.getByRole("button", { name: /^New empty maze/ }).click();
  await expect(other.driver("Me")).toBeChecked();
  await other.letDrive("Program");
  await other.mazeMenu.click();
  await other.page
    .getByRole("button", { name: /How far is the wall/ })
    .first()
    .click();
  await expect(other.driver("Me")).toBeChecked();
});

test("keeps what is done in two tabs", async ({ corridor, page, context }) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(3);
  const other = new CorridorPage(await context.newPage());
  await other.open();
  const theirs = new LessonsPanel(other.page);
  await theirs.openMission(4);
  await other.program.line(2).focus();
  await other.page.keyboard.press("Alt+ArrowUp");
  await other.speed.selectOption("16×");
  await other.run.click();
  await expect(theirs.outcome).toHaveText("Challenge met: 2 of 2 lines used");
  await page.bringToFront();
  await corridor.program.action(1).selectOption("turn 180");
  await corridor.speed.selectOption("16×");
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText("Challenge met: 1 of 1 lines used");
  await lessons.openPath();
  await expect(lessons.path).toContainText("2 of 14 done");
  await other.page.bringToFront();
  await theirs.openPath();
  await expect(theirs.path).toContainText("2 of 14 done");
  await corridor.open();
  await lessons.openPath();
  await expect(lessons.path).toContainText("2 of 14 done");
});

test("opens hints one by one", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await corridor.open();
  await lessons.openMission(7);
  await expect(lessons.hints).toHaveCount(0);
  await lessons.button("Show a hint").click();
  await expect(lessons.hints).toHaveCount(1);
  await lessons.button("Show hint 2 of 3").click();
  await lessons.button("Show hint 3 of 3").click();
  await expect(lessons.hints).toHaveCount(3);
  await expect(lessons.button(/^Show/)).toHaveCount(0);
});

test("is told what failed, with the number, while the robot drives", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(8);
  await corridor.program.action(1).selectOption("delayed left 90");
  await corridor.speed.selectOption("16×");
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText(
    /^Bump at 4\.\d s\. Line 1 chose “delayed left 90” with 50 cm in front\. .* needs 75 cm\.$/,
  );
  await corridor.program.action(1).selectOption("left 90");
  await corridor.reset.click();
  await corridor.run.click();
  await expect(lessons.outcome).toHaveText("Challenge met: 1 of 1 lines used");
});

test("lets go of the key where the sensor says", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(2);
  // Slow, so that a busy machine does not let go too late.
  await corridor.speed.selectOption("0.5×");
  await corridor.speed.blur();
  await page.keyboard.press("w", { delay: 400 });
  await expect(lessons.outcome).toHaveText(
    /^The robot stopped where the sensor reads 6\d\d cm\. The nearest place that counts reads 170 cm\.$/,
  );
  await page.keyboard.down("w");
  await expect
    .poll(async () => Number(await corridor.sensor("front").textContent()), { intervals: [20] })
    .toBeLessThan(165);
  await page.keyboard.up("w");
  await expect(lessons.outcome).toHaveText(/^Challenge met after \d\.\d s$/);
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved).toContainText(/^Solved!The robot stands where the sensor reads 1\d\d cm\./);
  await solved.getByRole("button", { name: "Next mission" }).click();
  await lessons.expectMission(3);
});

test("sees the robot beside the card of a mission at 1024 x 768", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 1024, height: 768 } });
  await corridor.open();
  const { page } = corridor;
  const lessons = new LessonsPanel(page);
  const card = page.getByRole("region", { name: "Solved!" });
  const overlap = async (): Promise<number> => {
    await atRest(page);
    const place = (await corridor.robotPlace.textContent()) ?? "";
    const [x = 0, y = 0] = place.match(/\d+/g)?.map(Number) ?? [];
    const robot = await corridor.maze.robotBox(x, y);
    const box = await card.boundingBox();
    if (box === null) throw new Error("there is no card");
    const width = Math.min(robot.x + robot.side, box.x + box.width) - Math.max(robot.x, box.x);
    const height = Math.min(robot.y + robot.side, box.y + box.height) - Math.max(robot.y, box.y);
    return Math.max(0, width) * Math.max(0, height);
  };
  await lessons.openMission(2);
  await page.keyboard.down("w");
  await expect
    .poll(async () => Number(await corridor.sensor("front").textContent()), { intervals: [20] })
    .toBeLessThan(165);
  await page.keyboard.up("w");
  await expect(card).toBeVisible();
  expect(await overlap(), "mission 2").toBe(0);
  await lessons.openMission(3);
  await corridor.program.action(1).selectOption("turn 180");
  await corridor.speed.selectOption("16×");
  await corridor.run.click();
  await expect(card).toBeVisible();
  expect(await overlap(), "mission 3").toBe(0);
});

test("is told which maze fails", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(12);
  await corridor.speed.selectOption("16×");
  await corridor.run.click();
  const part = page.getByRole("region", { name: "Met in this maze. Now check all 3." });
  await part.getByRole("button", { name: "Check in all 3 mazes" }).click();
  await expect(part).toBeHidden();
  await expect(lessons.outcome).toHaveText(/^Maze 2: The goal was not reached in 40 s/);
  await expect(lessons.card).toContainText("Passes in 1 of 3 mazes.");
  await lessons.button("Open maze 2").click();
  await expect(lessons.button("Maze 2 fails")).toHaveAttribute("aria-pressed", "true");
  await corridor.maze.expectSquare({ column: 5, row: 3 }, "open, goal");
  // The right wall passes in all of them.
  await corridor.program.button("Add line").click();
  await corridor.program.condition(2).selectOption("right >");
  await corridor.program.number(2).fill("60");
  await corridor.program.action(2).selectOption("delayed right 90");
  await lessons.button("Check in all 3 mazes").click();
  await expect(lessons.outcome).toHaveText("Challenge met: 2 of 3 lines used");
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved).toContainText("Your program passes in all mazes: 3 of 3.");
  await expect(solved.getByRole("button", { name: "Next mission" })).toBeVisible();
});

test("menus offer only what the mission allows", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
  // Only the action can be chosen, from four.
  await lessons.openMission(3);
  await expect(corridor.program.action(1).getByRole("option")).toHaveText([
    "forward",
    "reverse",
    "left 90",
    "turn 180",
  ]);
  await expect(corridor.program.condition(1)).toBeDisabled();
  await expect(corridor.program.number(1)).toBeDisabled();
  // Given lines take the room that a button without use would.
  await expect(corridor.program.button("Add line")).toHaveCount(0);
  await expect(corridor.program.region).toContainText("The lines of this mission are given.");
  // Only the number can be changed.
  await lessons.openMission(5);
  await expect(corridor.program.action(1)).toBeDisabled();
  await expect(corridor.program.number(1)).toBeEnabled();
  // One line, about front alone.
  await lessons.openMission(6);
  await corridor.program.button("Add line").click();
  await expect(corridor.program.condition(1).getByRole("option")).toHaveText([
    "[Do nothing]",
    "front >",
    "front <",
  ]);
  await expect(corridor.program.button("Add line")).toBeDisabled();
  await expect(corridor.program.button("Add line")).toHaveAccessibleDescription(
    "This mission allows 1 line.",
  );
  // The maze stays as it is, and says so.
  await corridor.maze.click({ column: 3, row: 1 });
  await expect(corridor.message(/The maze of this mission stays as it is/)).toBeVisible();
  await corridor.maze.expectSquare({ column: 3, row: 1 }, "open");
});

test("goes back to the own maze", async ({ corridor, page }) => {
  const lessons = new LessonsPanel(page);
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
  // The attempt waits where it was left.
  await lessons.openMission(6);
  await expect(corridor.program.lines).toHaveCount(1);
});

test("does a mission with the keyboard alone", async ({ corridor, page }) => {
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
  await page.keyboard.press("Control+Enter");
  await expect(lessons.outcome).toHaveText("Challenge met: 2 of 2 lines used", { timeout: 20_000 });
});

test("shares a challenge, and who opens the link has its bar, its rules and the way home", async ({
  corridor,
  page,
  openWindow,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openMission(7);
  await page.getByRole("button", { name: "Share", exact: true }).click();
  const dialog = corridor.dialog("Share this challenge");
  await expect(dialog.getByRole("checkbox", { name: "Challenge" })).toBeChecked();
  await expect(dialog).toContainText("Turn into the opening on the right");
  const link = await dialog.getByRole("textbox", { name: "Link" }).inputValue();

  const reader = await openWindow();
  await reader.open(link);
  const theirs = new LessonsPanel(reader.page);
  await expect(theirs.card).toContainText("The side opening");
  await expect(
    reader.page.getByRole("main").getByText("Turn into the opening on the right"),
  ).toBeVisible();
  await expect(reader.program.number(1)).toBeDisabled();
  await reader.program.action(1).selectOption("delayed right 90");
  await reader.speed.selectOption("16×");
  await reader.run.click();
  await expect(theirs.outcome).toHaveText("Challenge met: 1 of 1 lines used");
  await reader.open();
  await expect(theirs.card).toContainText("The side opening");
  await theirs.button("Back to my maze").click();
  await expect(theirs.card).toBeHidden();
  await expect(reader.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
});

test("meets no barrier in the path, in a mission and in its verdict", async ({
  page,
  corridor,
}) => {
  const lessons = new LessonsPanel(page);
  await lessons.openPath();
  await expectNoBarriers(page, "path of missions");
  await page.keyboard.press("Escape");
  await lessons.openMission(12);
  await lessons.button("Show a hint").click();
  await lessons.button("Check in all 3 mazes").click();
  await expect(lessons.card).toContainText("Passes in 1 of 3 mazes.");
  await expectNoBarriers(page, "a mission that does not pass yet");
  await corridor.dismissMessages();
});

test("finds nothing beyond the edges in a mission at 320 x 700", async ({ openWindow }) => {
  const corridor = await openWindow({ viewport: { width: 320, height: 700 } });
  await corridor.open();
  const { page } = corridor;
  const lessons = new LessonsPanel(page);
  expect(await stickingOut(page), "invitation").toEqual([]);
  await page.getByRole("banner").getByRole("button", { name: "More" }).click();
  await page.getByRole("dialog", { name: "More" }).getByRole("button", { name: "Lessons" }).click();
  await expect(lessons.path).toBeVisible();
  expect(await stickingOut(page), "path").toEqual([]);
  await lessons.path.getByRole("button", { name: /^12\. / }).click();
  await lessons.button("Check in all 3 mazes").click();
  await expect(lessons.card).toContainText("Passes in 1 of 3 mazes.");
  expect(await stickingOut(page), "mission").toEqual([]);
  await page.getByRole("tab", { name: "Drive" }).click();
  expect(await stickingOut(page), "slim").toEqual([]);
});

/** As a teacher may write one: no mission, and another goal. */
const everySquare: ChallengeDocument = {
  format: "corridor/challenge",
  version: 1,
  name: "Sweep the corridor",
  words: {
    task: "Visit every square without a bump.",
    short: "Visit every square in 1 line",
    hints: ["Where does the robot turn round?"],
  },
  mazes: [
    {
      format: "corridor/maze",
      version: 1,
      name: "Sweep the corridor",
      blocks: ["......"],
      start: { column: 3, row: 0, heading: "east" },
      goals: [],
    },
  ],
  program: null,
  goal: { kind: "visit" },
  allowed: {
    drivers: ["program"],
    lines: 1,
    conditions: null,
    actions: null,
    edits: ["condition", "number", "action", "otherwise", "lines"],
    maze: false,
  },
  checks: { bumps: 0, seconds: 60 },
  par: null,
};

test("meets a teacher's challenge from a link: every square in one line", async ({
  openWindow,
}) => {
  const link = encodeLink({ challenge: everySquare });
  if (!link.ok) throw new Error(link.code);
  const corridor = await openWindow();
  await corridor.open(`/#${link.text}`);
  const lessons = new LessonsPanel(corridor.page);
  await expect(lessons.card).toContainText("Visit every square without a bump.");
  await expect(corridor.message("You opened a shared challenge.")).toBeVisible();
  await corridor.program.addLine("front <", "50", "right 90");
  await lessons.button("Check the program").click();
  await expect(lessons.outcome).toHaveText("Challenge met: 1 of 1 lines used");
  await corridor.program.number(1).fill("20");
  await lessons.button("Check the program").click();
  await expect(lessons.outcome).toHaveText(/^Bump at 2\.\d s, row 1, column 6: no line was true/);
});
