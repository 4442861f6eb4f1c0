/**
 * Edits are stored on the device: across reloads and in two tabs. Where storage fails, the page
 * reports it.
 */
import { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";

const square = { column: 2, row: 6 };

async function restoresAfterReload(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await corridor.maze.click(square);
  await corridor.maze.tool("Goal").check();
  await corridor.maze.click({ column: 0, row: 0 });
  await corridor.program.number(1).fill("75");
  await corridor.program.name.fill("Mine");
  await corridor.program.button("Add line").click();
  await corridor.reload();
  await corridor.maze.expectSquare(square, "block");
  await corridor.maze.expectSquare({ column: 0, row: 0 }, "open, goal");
  await expect(corridor.program.name).toHaveValue("Mine");
  await expect(corridor.program.number(1)).toHaveValue("75");
  await expect(corridor.program.lines).toHaveCount(3);
  await expect(corridor.saveState).toHaveText("Saved on this device");

  await corridor.mazeMenu.click();
  const menu = corridor.dialog("Maze menu");
  await menu.getByRole("textbox", { name: "Name of the maze" }).fill("My first maze");
  await page.keyboard.press("Escape");
  await expect(corridor.mazeMenu).toHaveAccessibleName("My first maze, Maze menu");
  await corridor.mazeMenu.click();
  await menu.getByRole("button", { name: /^New empty maze/ }).click();
  await expect(corridor.mazeMenu).toHaveAccessibleName("New maze, Maze menu");
  await corridor.reload();
  await expect(corridor.mazeMenu).toHaveAccessibleName("New maze, Maze menu");

  await corridor.mazeMenu.click();
  await menu.getByRole("button", { name: "Open My first maze", exact: true }).click();
  await corridor.maze.expectSquare({ column: 10, row: 0 }, "open, goal");
  await corridor.mazeMenu.click();
  await menu.getByRole("button", { name: "Delete New maze", exact: true }).click();
  await expect(menu.getByRole("button", { name: "Open New maze", exact: true })).toBeHidden();
  await page.keyboard.press("Escape");
  await corridor.messages.getByRole("button", { name: "Undo" }).click();
  await corridor.mazeMenu.click();
  await expect(menu.getByRole("button", { name: "Open New maze", exact: true })).toBeVisible();
}

async function losesNoEditOfTwoTabs(corridor: CorridorPage): Promise<void> {
  await corridor.program.name.fill("In both tabs");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  const second = new CorridorPage(await corridor.page.context().newPage());
  await second.open();
  await expect(second.program.name).toHaveValue("In both tabs");
  await second.program.name.fill("Second tab");
  await expect(second.saveState).toHaveText("Saved on this device");
  await corridor.program.name.fill("First tab");
  await expect(corridor.message("You changed this maze in another tab too.")).toBeVisible();

  await corridor.reload();
  await expect(corridor.program.name).toHaveValue("First tab");
  await second.reload();
  await expect(second.program.name).toHaveValue("Second tab");
}

async function worksWithoutStorage(corridor: CorridorPage): Promise<void> {
  // Browsers behave like this when the user has turned storage off.
  await corridor.page.addInitScript(() => {
    for (const name of ["localStorage", "sessionStorage"]) {
      Object.defineProperty(window, name, {
        get() {
          throw new DOMException("Access is denied.", "SecurityError");
        },
      });
    }
  });
  await corridor.open();
  await corridor.maze.click(square);
  await expect(corridor.saveState).toHaveText("Not saved");
  await expect(corridor.message("Your maze and program are not saved")).toBeVisible();
  await corridor.maze.expectSquare(square, "block");
  await corridor.maze.click(square);
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toContainText("Goal reached");
}

test("stores maze and program on the device, and reports where it is not allowed", async ({
  corridor,
}) => {
  await test.step("restores maze and program after a reload, and lists all mazes in the menu", () =>
    restoresAfterReload(corridor));
  await test.step("edits the same maze in two tabs and loses neither edit", () =>
    losesNoEditOfTwoTabs(corridor));
  await test.step("shows that the device stores nothing, and remains usable", async () =>
    worksWithoutStorage(new CorridorPage(await corridor.page.context().newPage())));
});

test("shows that the storage is full until there is space, and sets a damaged maze aside", async ({
  corridor,
  page,
}) => {
  await page.evaluate(() => {
    // Fills the site's quota to the last characters.
    for (let size = 8_000_000; size >= 1; size = Math.floor(size / 2)) {
      try {
        for (let part = 0; ; part++) localStorage.setItem(`full-${size}-${part}`, "x".repeat(size));
      } catch {
        // Does not fit any more; try half the size.
      }
    }
  });
  await corridor.maze.click(square);
  await expect(corridor.saveState).toHaveText("Not saved");
  await expect(corridor.message("the storage of this device is full or turned off")).toBeVisible();
  await page.evaluate(() => localStorage.clear());
  await corridor.maze.click({ column: 3, row: 6 });
  await expect(corridor.saveState).toHaveText("Saved on this device");
  await corridor.reload();
  await corridor.maze.expectSquare(square, "block");
  await corridor.maze.expectSquare({ column: 3, row: 6 }, "open");
  await test.step("a damaged saved maze", async () => {
    await expect(corridor.saveState).toHaveText("Saved on this device");
    await page.evaluate(() => {
      for (const key of Object.keys(localStorage)) {
        const text = localStorage.getItem(key) ?? "";
        if (text.includes("corridor/maze")) localStorage.setItem(key, text.slice(0, -20));
      }
    });
    await corridor.reload();
    await expect(
      corridor.message("A saved maze cannot be opened. It was not deleted."),
    ).toBeVisible();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
    await corridor.maze.expectSquare(square, "open");
  });
});
