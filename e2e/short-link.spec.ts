/** Short links to a maze, which the service stores, serves and deletes. */
import { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

test("creates short links of a maze and a program, from which another user opens them, and deletes one", async ({
  corridor,
  page,
  pageErrors,
  openWindow,
}) => {
  await corridor.choosePreset("Spiral");
  await corridor.program.addLine("front <", "55", "left 90");
  const lines = await corridor.program.lines.count();
  await corridor.share.click();
  const dialog = corridor.dialog("Share this maze");
  const field = dialog.getByRole("textbox", { name: "Link" });
  const createLink = dialog.getByRole("button", { name: "Short link", exact: true });
  await expect(dialog.getByText("Anyone can open a short link")).toBeVisible();
  await createLink.click();
  await expect(field).toHaveValue(/\/m\/[A-Z]{4,6}$/);
  await dialog.getByRole("button", { name: "Copy link" }).click();
  await expect(dialog.getByText("Link copied")).toBeAttached();
  const ofMaze = await page.evaluate(() => navigator.clipboard.readText());
  expect(ofMaze).toBe(await field.inputValue());
  await dialog.getByRole("checkbox", { name: /^My program/ }).check();
  await expect(field).toHaveValue(/#/);
  await createLink.click();
  await expect(field).toHaveValue(/\/m\//);
  const ofBoth = await field.inputValue();
  expect(ofBoth).not.toBe(ofMaze);
  // Each choice has its own link.
  await dialog.getByRole("checkbox", { name: /^My program/ }).uncheck();
  await expect(field).toHaveValue(ofMaze);

  const recipient = await openWindow(wideWindow);
  const own = { column: 2, row: 6 };
  await recipient.open();
  await recipient.maze.click(own);
  await expect(recipient.saveState).toHaveText("Saved on this device");
  await recipient.open(ofMaze);
  await expect(recipient.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  await expect(
    recipient.message("You opened a shared maze. Your own maze and program are saved."),
  ).toBeVisible();
  expect(new URL(recipient.page.url()).pathname).toBe("/");
  await recipient.messages.getByRole("button", { name: "Back to my maze" }).click();
  await expect(recipient.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await recipient.maze.expectSquare(own, "block");
  await recipient.open(ofBoth);
  await expect(recipient.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  await expect(recipient.message("You opened a shared maze.")).toBeVisible();
  await expect(recipient.program.lines).toHaveCount(lines);
  await expect(recipient.program.number(lines)).toHaveValue("55");

  await test.step("a deleted link says so to users who open it", async () => {
    // The link of the maze is in the field.
    await dialog.getByRole("button", { name: "Delete short link" }).click();
    await expect(dialog.getByText("The short link is deleted.")).toBeVisible();
    await expect(createLink).toBeVisible();
    await expect(field).toHaveValue(/#/);
    pageErrors.ignoreFailedRequests();
    await recipient.open(ofMaze);
    await expect(recipient.message(/^This short link does not work/)).toBeVisible();
    await recipient.messages.getByRole("button", { name: "Open an empty maze" }).click();
    await expect(recipient.mazeMenu).toHaveAccessibleName("New maze, Maze menu");
  });

  await test.step("a run has only a long link", async () => {
    await page.keyboard.press("Escape");
    await corridor.step.click();
    await corridor.share.click();
    await createLink.click();
    await expect(field).toHaveValue(/\/m\//);
    await dialog.getByRole("checkbox", { name: /^This run/ }).check();
    const ofRun = corridor.dialog("Share this run");
    await expect(ofRun.getByRole("textbox", { name: "Link" })).toHaveValue(/#/);
    await expect(ofRun.getByRole("button", { name: "Short link", exact: true })).toBeDisabled();
    await expect(ofRun.getByText("A short link cannot contain a run")).toBeVisible();
  });
});

test("offers no short link where there is no service", async ({ browser, relay }) => {
  const context = await browser.newContext({ baseURL: relay });
  await context.route(/\/(healthz|api\/)/, (route) => route.fulfill({ status: 404 }));
  const corridor = new CorridorPage(await context.newPage());
  await corridor.open();
  const healthChecked = corridor.page.waitForResponse(/\/healthz$/);
  await corridor.share.click();
  await healthChecked;
  const dialog = corridor.dialog("Share this maze");
  await expect(dialog.getByRole("textbox", { name: "Link" })).toHaveValue(/#/);
  await expect(dialog.getByRole("button", { name: "Short link", exact: true })).toHaveCount(0);
  await context.close();
});
