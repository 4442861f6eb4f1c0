/** A maze travels by a short link, which the service keeps, shows to its readers and deletes. */
import { CorridorPage } from "./pages/corridor-page.ts";
import { expect, test } from "./fixtures.ts";

test("makes a short link, and another reader opens the maze from it", async ({
  corridor,
  page,
  openWindow,
}) => {
  await corridor.choosePreset("Spiral");
  await corridor.share.click();
  const dialog = corridor.dialog("Share this maze");
  const field = dialog.getByRole("textbox", { name: "Link" });
  await expect(dialog.getByText("Anybody can open a short link")).toBeVisible();
  await dialog.getByRole("button", { name: "Short link", exact: true }).click();
  await expect(field).toHaveValue(/\/m\/[A-Z]{4,6}$/);
  await dialog.getByRole("button", { name: "Copy link" }).click();
  await expect(dialog.getByText("Link copied")).toBeAttached();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toBe(await field.inputValue());

  const reader = await openWindow();
  await reader.open();
  await reader.maze.click({ column: 2, row: 6 });
  await expect(reader.saveState).toHaveText("Saved on this device");
  await reader.open(link);
  await expect(reader.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  await expect(reader.message("You opened a shared maze. Your own work is saved.")).toBeVisible();
  expect(new URL(reader.page.url()).pathname).toBe("/");
  await reader.messages.getByRole("button", { name: "Back to my maze" }).click();
  await expect(reader.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await reader.maze.expectSquare({ column: 2, row: 6 }, "block");
});

test("says that a program does not go along, and gives the long link for it", async ({
  corridor,
}) => {
  await corridor.share.click();
  const dialog = corridor.dialog("Share this maze");
  const make = dialog.getByRole("button", { name: "Short link", exact: true });
  await make.click();
  const field = dialog.getByRole("textbox", { name: "Link" });
  await expect(field).toHaveValue(/\/m\//);
  await dialog.getByRole("checkbox", { name: /^My program/ }).check();
  await expect(field).toHaveValue(/#/);
  await expect(make).toBeDisabled();
  await expect(
    dialog.getByText("A short link contains only the maze or the challenge."),
  ).toBeVisible();
  await dialog.getByRole("checkbox", { name: /^My program/ }).uncheck();
  await expect(field).toHaveValue(/\/m\//);
});

test("deletes a short link, and whoever opens it then is told so", async ({
  corridor,
  browser,
}) => {
  await corridor.maze.click({ column: 3, row: 5 });
  await corridor.share.click();
  const dialog = corridor.dialog("Share this maze");
  const field = dialog.getByRole("textbox", { name: "Link" });
  const make = dialog.getByRole("button", { name: "Short link", exact: true });
  await make.click();
  await expect(field).toHaveValue(/\/m\//);
  const link = await field.inputValue();
  await dialog.getByRole("button", { name: "Delete short link" }).click();
  await expect(dialog.getByText("The short link is deleted.")).toBeVisible();
  await expect(make).toBeVisible();
  await expect(field).toHaveValue(/#/);

  // Not a watched window: the browser itself notes the 404.
  const context = await browser.newContext();
  const reader = new CorridorPage(await context.newPage());
  await reader.open(link);
  await expect(reader.message(/^This short link does not work/)).toBeVisible();
  await expect(reader.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await reader.messages.getByRole("button", { name: "Open an empty maze" }).click();
  await expect(reader.mazeMenu).toHaveAccessibleName("New maze, Maze menu");
  await context.close();
});

test("offers no short link where there is no service", async ({ browser, relay }) => {
  const context = await browser.newContext({ baseURL: relay });
  await context.route(/\/(healthz|api\/)/, (route) => route.fulfill({ status: 404 }));
  const corridor = new CorridorPage(await context.newPage());
  await corridor.open();
  const asked = corridor.page.waitForResponse(/\/healthz$/);
  await corridor.share.click();
  await asked;
  const dialog = corridor.dialog("Share this maze");
  await expect(dialog.getByRole("textbox", { name: "Link" })).toHaveValue(/#/);
  await expect(dialog.getByRole("button", { name: "Short link", exact: true })).toHaveCount(0);
  await context.close();
});
