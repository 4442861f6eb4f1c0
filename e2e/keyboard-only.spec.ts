/** A full session without a mouse: every step is a key press, and the focus is never lost. */
import { expect, test } from "./fixtures.ts";
import { LessonsPanel } from "./pages/lessons-panel.ts";
import { KeyboardUser } from "./support/keyboard-user.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

test("builds, programs, runs, bumps, fixes, goes back in time, solves and shares by keyboard alone", async ({
  corridor,
  page,
}) => {
  test.slow();
  const user = new KeyboardUser(page);
  const { maze, program, timeline } = corridor;

  // Maze: an empty one, with a row of blocks, a new start and a new goal.
  await user.press(page.getByRole("button", { name: "Presets", exact: true }));
  await user.press(corridor.dialog("Presets").getByRole("button", { name: /^Empty/ }));
  await expect(corridor.mazeMenu).toHaveAccessibleName("Empty, Maze menu");
  await expect(corridor.dialog("Presets")).toBeHidden();
  await user.expectFocus();

  await user.tabTo(maze.cursor);
  await user.key("Control+Home");
  await expect(maze.cursor).toHaveAccessibleName(/^row 1, column 1/);
  await user.key("ArrowDown", "ArrowDown");
  for (let column = 0; column < 4; column++) await user.key("Space", "ArrowRight");
  await expect(maze.cursor).toHaveAccessibleName("row 3, column 5, open");
  await user.key("ArrowLeft");
  await expect(maze.cursor).toHaveAccessibleName("row 3, column 4, block");

  await user.tabTo(page.getByRole("group", { name: "Tool" }).getByRole("radio", { checked: true }));
  await user.key("ArrowRight");
  await expect(maze.tool("Start")).toBeChecked();
  await user.tabTo(maze.cursor);
  await user.key("Control+Home", "ArrowDown", "Enter");
  await expect(maze.cursor).toHaveAccessibleName(/^row 2, column 1, open, start, facing right/);

  await user.tabTo(page.getByRole("group", { name: "Tool" }).getByRole("radio", { checked: true }));
  await user.key("ArrowRight");
  await expect(maze.tool("Goal")).toBeChecked();
  await user.tabTo(maze.cursor);
  await user.key("End", "PageUp", "Enter");
  await expect(maze.cursor).toHaveAccessibleName(/goal$/);

  // Program: a new maze has none. Add one line through its menus; the line turns too late.
  await expect(program.lines).toHaveCount(0);
  await user.press(program.button("Add line"));
  await expect(program.condition(1)).toBeFocused();
  await user.choose(program.condition(1), "front <");
  await user.type(program.number(1), "60");
  await user.choose(program.action(1), "delayed left 90");
  await user.press(corridor.reset);
  await user.choose(corridor.speed, "max");
  await user.key("Control+Enter");

  // The bump card explains the bump and fixes the line.
  const card = corridor.bumpCard(1);
  await expect(card).toBeVisible({ timeout: 30_000 });
  await user.tabTo(card.getByRole("button", { name: /^Change/ }).first());
  await expect(card).toContainText("It drives on first and needs 75 cm");
  await user.key("Enter");
  await expect(card).toBeHidden();
  await expect(program.action(1)).toHaveValue("left 90");

  // Timeline: go back to before the bump and run from there.
  await user.tabTo(timeline.slider);
  await user.key("ArrowLeft");
  await expect(timeline.pastLabel).toBeVisible();
  await expect(corridor.bumps).toHaveText("0 bumps");
  await user.press(timeline.runFromHere);
  await expect(timeline.pastLabel).toBeHidden();
  const solved = page.getByRole("region", { name: "Solved!" });
  await expect(solved).toBeVisible({ timeout: 30_000 });
  await user.expectFocus();
  await user.press(solved.getByRole("button", { name: "Close" }));
  await expect(solved).toBeHidden();

  // Share: the link is copied, and the dialog returns the focus.
  await user.press(corridor.share);
  const dialog = corridor.dialog("Share this maze");
  await expect(dialog).toBeVisible();
  await user.press(dialog.getByRole("button", { name: "Copy link" }));
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toMatch(/#1/);
  await user.key("Escape");
  await expect(dialog).toBeHidden();
  await expect(corridor.share).toBeFocused();
});

test("stops the robot, keeps the focus, cycles through dialogs and solves a mission by keyboard alone", async ({
  corridor,
  page,
}) => {
  test.slow();
  const user = new KeyboardUser(page);
  const { timeline } = corridor;

  await test.step("closes what is open with Escape, and otherwise stops the robot", async () => {
    await user.press(corridor.run);
    await expect(corridor.pause).toBeVisible();
    await user.key("Shift+?");
    const list = corridor.dialog("Keyboard shortcuts");
    await expect(list).toBeVisible();
    await user.key("Escape");
    await expect(list).toBeHidden();
    await expect(corridor.pause).toBeVisible();
    await user.key("Escape");
    await expect(corridor.run).toBeVisible();
    await user.press(corridor.reset);
    await expect(corridor.clock).toHaveText("Time 0:00.0");
  });

  await test.step("keeps the focus when the focused control is removed or disabled", async () => {
    // An invitation that is dismissed.
    await user.press(page.getByRole("button", { name: "Not now" }));
    await user.expectFocusVisible();
    // Undo becomes disabled after its last use.
    await user.tabTo(corridor.maze.cursor);
    await user.key("ArrowRight", "Space");
    await user.press(corridor.maze.button("Undo"));
    await expect(corridor.maze.button("Undo")).toBeDisabled();
    await user.expectFocusVisible();
    // A message is dismissed.
    await user.tabTo(corridor.program.line(2));
    await user.key("Delete");
    const dismiss = corridor.messages.getByRole("button", { name: "Dismiss" });
    // The message disappears after 6 s, unless the pointer is on it. Tab may need longer.
    await dismiss.hover();
    await user.press(dismiss);
    await user.expectFocusVisible();
    // "Back to now" is removed with the past.
    await user.press(corridor.step);
    await expect(corridor.run).toBeVisible();
    await user.press(timeline.previousDecision);
    await user.press(timeline.backToNow);
    await expect(timeline.backToNow).toBeHidden();
    await user.expectFocusVisible();
    await expect(corridor.transport.locator(":focus")).toHaveCount(1);
  });

  await test.step("cycles through a dialog with Tab, and returns the focus to its button", async () => {
    for (const [button, title] of [
      [corridor.share, "Share this maze"],
      [page.getByRole("button", { name: "Keyboard shortcuts" }), "Keyboard shortcuts"],
      [corridor.maze.button("Resize"), "Resize the maze"],
      [corridor.maze.button("Clear maze"), "Clear this maze?"],
      [page.getByRole("banner").getByRole("button", { name: "Lessons" }), "Lessons"],
    ] as const) {
      await user.press(button);
      const dialog = corridor.dialog(title);
      await expect(dialog).toBeVisible();
      await page.keyboard.press("Tab");
      const first = await page.evaluateHandle(() => document.activeElement);
      let isCycle = false;
      for (let stop = 1; stop <= 40 && !isCycle; stop++) {
        await page.keyboard.press("Tab");
        // After the last control, Tab moves to the browser's own controls and then into the dialog
        // again.
        const focus = await dialog.evaluate((element, start) => {
          const focused = document.activeElement;
          return {
            isOut: focused !== document.body && !element.contains(focused),
            isFirst: focused === start,
          };
        }, first);
        expect(focus.isOut, `${title}: out of the dialog after ${stop + 1} presses`).toBe(false);
        isCycle = focus.isFirst;
      }
      expect(isCycle, `${title}: Tab returns to its first control`).toBe(true);
      await page.keyboard.press("Escape");
      await expect(dialog).toBeHidden();
      await expect(button).toBeFocused();
    }
  });

  await test.step("opens a mission and solves it", async () => {
    const lessons = new LessonsPanel(page);
    await user.press(page.getByRole("banner").getByRole("button", { name: "Lessons" }));
    await user.press(lessons.path.getByRole("button", { name: /^3\. / }));
    await lessons.expectMission(3);
    await user.expectFocus();
    await user.press(lessons.button("Show a hint"));
    await expect(lessons.hints).toHaveCount(1);
    await user.choose(corridor.program.action(1), "turn 180");
    await user.choose(corridor.speed, "16×");
    await user.key("Control+Enter");
    await expect(lessons.outcome).toHaveText("Task solved. Lines used: 1 of 1");
    const solved = page.getByRole("region", { name: "Solved!" });
    await user.press(solved.getByRole("button", { name: "Next mission" }));
    await lessons.expectMission(4);
    await user.expectFocus();
    await user.press(lessons.button("Back to my maze"));
    await expect(lessons.card).toBeHidden();
    await user.expectFocus();
  });
});
