/** The whole loop without a mouse: every step is a key, and the focus is never lost. */
import { expect, test } from "./fixtures.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { KeyboardUser } from "./support/keyboard-user.ts";

test("builds, programs, runs, bumps, mends, goes back in time, solves and shares by keys alone", async ({
  corridor,
  page,
}) => {
  test.slow();
  const keys = new KeyboardUser(page);
  const { maze, program, timeline } = corridor;

  // A maze: an empty one, a row of blocks, another start, another goal.
  await keys.press(page.getByRole("button", { name: "Presets", exact: true }));
  await keys.press(corridor.dialog("Presets").getByRole("button", { name: /^Empty/ }));
  await expect(corridor.mazeMenu).toHaveAccessibleName("Empty, Maze menu");
  await expect(corridor.dialog("Presets")).toBeHidden();
  await keys.expectFocus();

  await keys.tabTo(maze.cursor);
  await keys.key("Control+Home");
  await expect(maze.cursor).toHaveAccessibleName(/^row 1, column 1/);
  await keys.key("ArrowDown", "ArrowDown");
  for (let column = 0; column < 4; column++) await keys.key("Space", "ArrowRight");
  await expect(maze.cursor).toHaveAccessibleName("row 3, column 5, open");
  await keys.key("ArrowLeft");
  await expect(maze.cursor).toHaveAccessibleName("row 3, column 4, block");

  await keys.tabTo(page.getByRole("group", { name: "Tool" }).getByRole("radio", { checked: true }));
  await keys.key("ArrowRight");
  await expect(maze.tool("Start")).toBeChecked();
  await keys.tabTo(maze.cursor);
  await keys.key("Control+Home", "ArrowDown", "Enter");
  await expect(maze.cursor).toHaveAccessibleName(/^row 2, column 1, open, start, facing right/);

  await keys.tabTo(page.getByRole("group", { name: "Tool" }).getByRole("radio", { checked: true }));
  await keys.key("ArrowRight");
  await expect(maze.tool("Goal")).toBeChecked();
  await keys.tabTo(maze.cursor);
  await keys.key("End", "PageUp", "Enter");
  await expect(maze.cursor).toHaveAccessibleName(/goal$/);

  // The program, which is empty in a new maze: one line by its menus, which turns too late.
  await expect(program.lines).toHaveCount(0);
  await keys.press(program.button("Add line"));
  await expect(program.condition(1)).toBeFocused();
  await keys.choose(program.condition(1), "front <");
  await keys.type(program.number(1), "60");
  await keys.choose(program.action(1), "delayed left 90");
  await keys.press(corridor.reset);
  await keys.key("Control+Enter");

  // It bumps; the card says why and mends it.
  const card = corridor.bumpCard(1);
  await expect(card).toBeVisible({ timeout: 30_000 });
  await keys.tabTo(card.getByRole("button", { name: /^Change/ }).first());
  await expect(card).toContainText("It drives on first and needs 75 cm");
  await keys.key("Enter");
  await expect(card).toBeHidden();
  await expect(program.action(1)).toHaveValue("left 90");

  // Back on the timeline to before the bump, and on from there.
  await keys.tabTo(timeline.slider);
  await keys.key("ArrowLeft");
  await expect(timeline.pastLabel).toBeVisible();
  await expect(corridor.bumps).toHaveText("0 bumps");
  await keys.press(timeline.runFromHere);
  await expect(timeline.pastLabel).toBeHidden();
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved).toBeVisible({ timeout: 30_000 });
  await keys.expectFocus();
  await keys.press(solved.getByRole("button", { name: "Close" }));
  await expect(solved).toBeHidden();

  // The link is copied, and the dialog gives the focus back.
  await keys.press(corridor.share);
  const dialog = corridor.dialog("Share this maze");
  await expect(dialog).toBeVisible();
  await keys.press(dialog.getByRole("button", { name: "Copy link" }));
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toMatch(/#1/);
  await keys.key("Escape");
  await expect(dialog).toBeHidden();
  await expect(corridor.share).toBeFocused();
});

test("opens a mission and solves it by keys alone", async ({ corridor, page }) => {
  test.slow();
  const keys = new KeyboardUser(page);
  const lessons = new LessonsPanel(page);
  await keys.press(page.getByRole("banner").getByRole("button", { name: "Lessons" }));
  await keys.press(lessons.path.getByRole("button", { name: /^3\. / }));
  await lessons.expectMission(3);
  await keys.expectFocus();
  await keys.press(lessons.button("Show a hint"));
  await expect(lessons.hints).toHaveCount(1);
  await keys.choose(corridor.program.action(1), "turn 180");
  await keys.choose(corridor.speed, "16×");
  await keys.key("Control+Enter");
  await expect(lessons.outcome).toHaveText("Challenge solved. Lines used: 1 of 1");
  const solved = page.getByRole("region", { name: "Solved!" });
  await keys.press(solved.getByRole("button", { name: "Next mission" }));
  await lessons.expectMission(4);
  await keys.expectFocus();
  await keys.press(lessons.button("Back to my maze"));
  await expect(lessons.card).toBeHidden();
  await keys.expectFocus();
});

test("keeps the focus where something goes or is switched off", async ({ corridor, page }) => {
  test.slow();
  const keys = new KeyboardUser(page);
  const { timeline } = corridor;
  // The invitation that is sent away.
  await keys.press(page.getByRole("button", { name: "Not now" }));
  await keys.expectFocusVisible();
  // Undo, after which there is nothing left to undo.
  await keys.tabTo(corridor.maze.cursor);
  await keys.key("ArrowRight", "Space");
  await keys.press(corridor.maze.button("Undo"));
  await expect(corridor.maze.button("Undo")).toBeDisabled();
  await keys.expectFocusVisible();
  // A message that is dismissed.
  await keys.tabTo(corridor.program.line(2));
  await keys.key("Delete");
  await keys.press(corridor.messages.getByRole("button", { name: "Dismiss" }));
  await keys.expectFocusVisible();
  // Back to now, which goes with the past.
  await keys.press(corridor.step);
  await expect(corridor.run).toBeVisible();
  await keys.press(timeline.previousDecision);
  await keys.press(timeline.backToNow);
  await expect(timeline.backToNow).toBeHidden();
  await keys.expectFocusVisible();
  await expect(corridor.transport.locator(":focus")).toHaveCount(1);
});

test("stays in a dialog with Tab, and comes back to its button", async ({ corridor, page }) => {
  test.slow();
  const keys = new KeyboardUser(page);
  for (const [button, title] of [
    [corridor.share, "Share this maze"],
    [page.getByRole("button", { name: "Keyboard shortcuts" }), "Keyboard shortcuts"],
    [corridor.maze.button("Resize"), "Resize the maze"],
    [corridor.maze.button("Clear maze"), "Clear this maze?"],
    [page.getByRole("banner").getByRole("button", { name: "Lessons" }), "Lessons"],
  ] as const) {
    await keys.press(button);
    const dialog = corridor.dialog(title);
    await expect(dialog).toBeVisible();
    for (let stop = 0; stop < 40; stop++) {
      await page.keyboard.press("Tab");
      // Past its end the browser's own controls come, and then the dialog again.
      const isOut = await dialog.evaluate(
        (element) =>
          document.activeElement !== document.body && !element.contains(document.activeElement),
      );
      expect(isOut, `${title}: out of the dialog after ${stop + 1} presses`).toBe(false);
    }
    await page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
    await expect(button).toBeFocused();
  }
});

test("closes what is open with Escape, and stops the robot with it otherwise", async ({
  corridor,
  page,
}) => {
  const keys = new KeyboardUser(page);
  await keys.press(corridor.run);
  await expect(corridor.pause).toBeVisible();
  await keys.key("Shift+?");
  const list = corridor.dialog("Keyboard shortcuts");
  await expect(list).toBeVisible();
  await keys.key("Escape");
  await expect(list).toBeHidden();
  await expect(corridor.pause).toBeVisible();
  await keys.key("Escape");
  await expect(corridor.run).toBeVisible();
});
