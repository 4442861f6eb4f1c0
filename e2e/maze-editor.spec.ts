/** Editing a maze by pointer and by keyboard. */
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import type { Square } from "./pages/maze-grid.ts";

const open: Square = { column: 2, row: 6 };
const filled: Square = { column: 3, row: 6 };

async function addsAndRemovesBlocks(corridor: CorridorPage): Promise<void> {
  await corridor.maze.expectSquare(open, "open");
  await corridor.maze.click(open);
  await corridor.maze.expectSquare(open, "block");
  await corridor.maze.click(open);
  await corridor.maze.expectSquare(open, "open");
  await corridor.maze.click(filled);
  await corridor.maze.expectSquare(filled, "open");
}

async function paintsRow(corridor: CorridorPage): Promise<void> {
  const { maze } = corridor;
  await corridor.choosePreset("Empty");
  const stroke = [2, 3, 4, 5, 6].map((column) => ({ column, row: 2 }));
  await maze.drag(stroke);
  for (const square of stroke) await maze.expectSquare(square, "block");
  await maze.button("Undo").click();
  for (const square of stroke) await maze.expectSquare(square, "open");
  await maze.button("Redo").click();
  for (const square of stroke) await maze.expectSquare(square, "block");
  await corridor.dismissMessages();
  // A drag that starts on a block only removes blocks.
  await maze.drag([
    { column: 2, row: 2 },
    { column: 2, row: 3 },
    { column: 3, row: 2 },
  ]);
  await maze.expectSquare({ column: 2, row: 2 }, "open");
  await maze.expectSquare({ column: 2, row: 3 }, "open");
  await maze.expectSquare({ column: 3, row: 2 }, "open");
}

async function reportsOccupiedSquares(corridor: CorridorPage): Promise<void> {
  const { maze } = corridor;
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toContainText("Goal reached");
  await maze.click({ column: 10, row: 0 });
  await expect(
    corridor.message("The robot is on this square. Drive it away or press Reset first."),
  ).toBeVisible();
  await maze.expectSquare({ column: 10, row: 0 }, "open, goal, robot here, facing up");
  await maze.click({ column: 0, row: 6 });
  await expect(corridor.message("This is the start. Move the start first.")).toBeVisible();
  await maze.expectSquare({ column: 0, row: 6 }, "open, start, facing right");
}

async function movesStartAndGoals(corridor: CorridorPage): Promise<void> {
  const { maze } = corridor;
  await maze.tool("Start").check();
  await maze.click({ column: 2, row: 6 });
  await corridor.reset.click();
  await expect(corridor.robotPose).toHaveText("Robot at 250, 650, facing right");
  await maze.click({ column: 2, row: 6 });
  await corridor.reset.click();
  await expect(corridor.robotPose).toHaveText("Robot at 250, 650, facing down");
  await maze.expectSquare(
    { column: 2, row: 6 },
    "open, start, facing down, robot here, facing down",
  );

  await maze.tool("Goal").check();
  await maze.click({ column: 0, row: 0 });
  await maze.expectSquare({ column: 0, row: 0 }, "open, goal");
  await maze.expectSquare({ column: 10, row: 0 }, "open, goal");
  await maze.click({ column: 10, row: 0 });
  await maze.expectSquare({ column: 10, row: 0 }, "open");
  await maze.click({ column: 3, row: 6 });
  await expect(corridor.message("There is a block on this square.")).toBeVisible();
}

async function clearsMaze(corridor: CorridorPage): Promise<void> {
  const { maze } = corridor;
  const dialog = corridor.dialog("Clear this maze?");
  await maze.button("Clear maze").click();
  await dialog.getByRole("button", { name: "Keep the maze" }).click();
  await expect(dialog).toBeHidden();
  await maze.expectSquare(filled, "block");

  await corridor.step.click();
  await maze.button("Clear maze").click();
  await dialog.getByRole("button", { name: "Clear maze" }).click();
  await expect(dialog).toBeHidden();
  await expect(maze.button("Clear maze")).toBeFocused();
  await maze.expectSquare(filled, "open");
  await maze.expectSquare({ column: 10, row: 0 }, "open, goal");
  await expect(corridor.robotPose).toHaveText("Robot at 50, 650, facing right");
  await maze.button("Undo").click();
  await maze.expectSquare(filled, "block");
}

async function resizesMaze(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { maze } = corridor;
  await maze.button("Resize").click();
  const dialog = corridor.dialog("Resize the maze");
  const columns = dialog.getByRole("textbox", { name: "Columns" });
  const rows = dialog.getByRole("textbox", { name: "Rows" });
  await expect(columns).toHaveValue("11");
  await expect(rows).toHaveValue("7");
  await columns.fill("257");
  await expect(dialog.getByText("Type a whole number from 1 to 256.")).toBeVisible();
  await dialog.getByRole("button", { name: "Resize maze" }).click();
  await expect(columns).toBeFocused();
  await columns.fill("33");
  await rows.fill("33");
  await dialog.getByRole("button", { name: "Resize maze" }).click();
  await expect(dialog).toBeHidden();
  await expect(maze.grid).toHaveAttribute("aria-colcount", "33");
  await expect(maze.grid).toHaveAttribute("aria-rowcount", "33");
  await maze.expectSquare({ column: 32, row: 32 }, "open");
  await page.keyboard.press("Control+z");
  await expect(maze.grid).toHaveAttribute("aria-colcount", "11");
}

async function editsByKeyboard(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  const { maze } = corridor;
  const { keyboard } = page;
  await page.keyboard.press("Tab");
  for (let stop = 0; stop < 30; stop++) {
    if (await maze.cursor.evaluate((cell) => cell === document.activeElement)) break;
    await keyboard.press("Tab");
  }
  // The cursor starts on the start square.
  await expect(maze.cursor).toBeFocused();
  await expect(maze.cursor).toHaveAccessibleName(/^row 7, column 1, open, start/);
  await keyboard.press("ArrowRight");
  await keyboard.press("ArrowRight");
  await expect(maze.cursor).toHaveAccessibleName("row 7, column 3, open");
  await keyboard.press("Space");
  await expect(maze.cursor).toHaveAccessibleName("row 7, column 3, block");
  await keyboard.press("ArrowRight");
  await expect(maze.cursor).toHaveAccessibleName("row 7, column 4, block");
  await keyboard.press("Enter");
  await expect(maze.cursor).toHaveAccessibleName("row 7, column 4, open");

  await keyboard.press("Control+z");
  await expect(maze.cursor).toHaveAccessibleName("row 7, column 4, block");
  await keyboard.press("Control+z");
  await maze.expectSquare(open, "open");
  await keyboard.press("Control+Shift+Z");
  await maze.expectSquare(open, "block");
  await keyboard.press("Control+Shift+Z");
  await maze.expectSquare(filled, "open");

  // The cursor stops at the edges, and Control+End and PageUp move to them.
  await keyboard.press("Control+End");
  await expect(maze.cursor).toHaveAccessibleName("row 7, column 11, open");
  await keyboard.press("ArrowDown");
  await expect(maze.cursor).toHaveAccessibleName("row 7, column 11, open");
  await keyboard.press("PageUp");
  await expect(maze.cursor).toHaveAccessibleName("row 1, column 11, open, goal");
  await expect(maze.cursor).toBeFocused();
}

async function paintsAroundMovingRobot(corridor: CorridorPage): Promise<void> {
  await corridor.choosePreset("Straight corridor");
  await corridor.program.loadAlgorithm("Back and forth");
  // Without a goal, the run does not end.
  await corridor.maze.tool("Goal").check();
  await corridor.maze.click({ column: 9, row: 1 });
  await corridor.maze.tool("Blocks").check();
  await corridor.run.click();
  await expect(corridor.pause).toBeVisible();
  await corridor.maze.click({ column: 5, row: 0 });
  await corridor.maze.expectSquare({ column: 5, row: 0 }, "open");
  const before = await corridor.clock.textContent();
  await expect(corridor.clock).not.toHaveText(before ?? "");
  await expect(corridor.pause).toBeVisible();
  await expect(corridor.bumps).toHaveText("0 bumps");
}

test("edits a maze by pointer and by keyboard", async ({ corridor }) => {
  const step = (title: string, check: (page: CorridorPage) => Promise<void>) =>
    test.step(title, async () => {
      await check(corridor);
      // The first maze again, without edits, messages and runs.
      await corridor.dismissMessages();
      await corridor.choosePreset("Long way round");
      await corridor.maze.tool("Blocks").check();
      await corridor.speed.selectOption("1");
      await corridor.dismissMessages();
    });
  // With the first program: a maze from the presets opens without one.
  await step(
    "reports why the squares of the robot and the start cannot be filled",
    reportsOccupiedSquares,
  );
  await step(
    "edits by keyboard alone: moves the cursor, adds, removes, undoes and redoes",
    editsByKeyboard,
  );
  await step(
    "adds a block with a click on a square, and removes it with a second click",
    addsAndRemovesBlocks,
  );
  await step("paints a row of blocks in one drag, and one Undo removes them all", paintsRow);
  await step("moves the start, turns it, and adds and removes goals", movesStartAndGoals);
  await step("clears the maze after a confirmation, and can undo it", clearsMaze);
  await step("resizes the maze, and reports the valid sizes", resizesMaze);
  await step("paints around a moving robot without stopping it", paintsAroundMovingRobot);
});
