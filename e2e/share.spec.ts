/**
 * A maze travels in a link: from a teacher's page into a student's, without touching their work.
 */
import { encodeLink } from "@corridor/link";
import { brokenDocuments } from "@corridor/link/testing";
import { generateTree } from "@corridor/maze";
import { expect, test } from "./fixtures.ts";

const sentences = {
  empty: "This link is empty.",
  "unknown-version": "Corridor cannot open this link. Maybe a newer version made it.",
  "cut-off": "A part of this link is missing.",
  damaged: "This link was changed, so it cannot be opened.",
  "too-long": "This link is too long for Corridor.",
};

test("copies a link, and another reader opens the maze from it with their own program", async ({
  corridor,
  page,
  openWindow,
}) => {
  await corridor.maze.click({ column: 2, row: 6 });
  await corridor.program.loadAlgorithm("Left wall");
  await corridor.share.click();
  const dialog = corridor.dialog("Share this maze");
  await dialog.getByRole("button", { name: "Copy link" }).click();
  await expect(dialog.getByText("Link copied")).toBeAttached();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  expect(link).toBe(await dialog.getByRole("textbox", { name: "Link" }).inputValue());

  const reader = await openWindow();
  await reader.open(link);
  // A reader who has never been here has no work to go back to.
  await expect(reader.message(/^You opened a shared maze\.$/)).toBeVisible();
  await expect(reader.messages.getByRole("button", { name: "Back to my maze" })).toHaveCount(0);
  await reader.maze.expectSquare({ column: 2, row: 6 }, "block");
  // The link brings no program, so that there is something to solve.
  await expect(reader.program.lines).toHaveCount(0);
  await expect(reader.program.region.getByText("Get the robot to the goal.")).toBeVisible();
  // The address is clean again, so that a reload keeps what the reader changes.
  expect(new URL(reader.page.url()).hash).toBe("");
});

test("holds the link in the address bar until what was shared changes", async ({
  corridor,
  page,
  openWindow,
}) => {
  await corridor.maze.click({ column: 2, row: 6 });
  const link = await corridor.shareLink({ withProgram: false });
  expect(page.url()).toBe(link);
  // The program is not in the link: it may change, and a reload keeps it.
  await corridor.program.otherwise.selectOption("reverse");
  await expect(corridor.saveState).toHaveText("Saved on this device");
  await corridor.reload();
  expect(page.url()).toBe(link);
  await expect(corridor.program.otherwise).toHaveValue("reverse");
  await expect(corridor.messages.getByRole("listitem")).toHaveCount(0);
  const reader = await openWindow();
  await reader.open(page.url());
  await reader.maze.expectSquare({ column: 2, row: 6 }, "block");
  await corridor.maze.click({ column: 4, row: 6 });
  await expect(page).toHaveURL(/\/$/);
});

test("opens one of our links where it is pasted, and leads back", async ({ corridor, page }) => {
  await corridor.choosePreset("Spiral");
  const link = await corridor.shareLink({ withProgram: false });
  await corridor.choosePreset("Tree");
  await page.evaluate((text) => navigator.clipboard.writeText(text), `${link}\n`);
  await page.keyboard.press("ControlOrMeta+V");
  await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  await expect(page).toHaveURL("/");
});

test("goes back in the browser to what was shared, though another link is open", async ({
  corridor,
  page,
}) => {
  await corridor.choosePreset("Comb");
  const other = await corridor.shareLink({ withProgram: false });
  await corridor.choosePreset("Spiral");
  await corridor.shareLink({ withProgram: false });
  await page.evaluate((text) => navigator.clipboard.writeText(text), other);
  await page.keyboard.press("ControlOrMeta+V");
  await expect(corridor.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
  await page.goBack();
  await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
});

test("puts the program into the link when asked to", async ({ corridor, openWindow }) => {
  await corridor.program.loadAlgorithm("Farthest distance");
  const link = await corridor.shareLink({ withProgram: true });
  const reader = await openWindow();
  await reader.open(link);
  await expect(reader.program.name).toHaveValue("Farthest distance");
  await expect(reader.program.lines).toHaveCount(3);
  await reader.speed.selectOption("max");
  await reader.run.click();
  await expect(reader.runNote).toContainText("tick 2310");
});

test("opens a link, keeps the own work, and goes back to it", async ({ corridor, openWindow }) => {
  await corridor.choosePreset("Spiral");
  const link = await corridor.shareLink({ withProgram: false });

  const reader = await openWindow();
  await reader.open();
  await reader.maze.click({ column: 2, row: 6 });
  await expect(reader.saveState).toHaveText("Saved on this device");
  await reader.open(link);
  await expect(reader.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  await expect(reader.message("You opened a shared maze. Your own work is saved.")).toBeVisible();
  await reader.messages.getByRole("button", { name: "Back to my maze" }).click();
  await expect(reader.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await reader.maze.expectSquare({ column: 2, row: 6 }, "block");

  // Both are in the maze menu, and the shared one is still as it came.
  await reader.mazeMenu.click();
  await reader
    .dialog("Maze menu")
    .getByRole("button", { name: "Open Spiral", exact: true })
    .click();
  await expect(reader.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
});

test("opens a link in a page that is open already", async ({ corridor, page }) => {
  await corridor.choosePreset("Tree");
  const link = await corridor.shareLink({ withProgram: false });
  await corridor.choosePreset("Comb");
  await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
  await expect(corridor.mazeMenu).toHaveAccessibleName("Tree, Maze menu");
  await expect(corridor.message("You opened a shared maze.")).toBeVisible();
});

test("makes a link of at most 200 characters for a maze of 33 by 33 squares", async ({
  corridor,
  openWindow,
}) => {
  await corridor.maze.button("Resize").click();
  const dialog = corridor.dialog("Resize the maze");
  await dialog.getByRole("textbox", { name: "Columns" }).fill("33");
  await dialog.getByRole("textbox", { name: "Rows" }).fill("33");
  await dialog.getByRole("button", { name: "Resize maze" }).click();
  const resized = await corridor.shareLink({ withProgram: false });
  expect(fragmentOf(resized).length).toBeLessThanOrEqual(200);

  const tree = encodeLink({ maze: generateTree({ columns: 33, rows: 33, seed: 2, name: "Big" }) });
  if (!tree.ok) throw new Error(tree.code);
  const reader = await openWindow();
  await reader.open(`/#${tree.text}`);
  await expect(reader.maze.grid).toHaveAttribute("aria-colcount", "33");
  const link = await reader.shareLink({ withProgram: false });
  expect(fragmentOf(link)).toBe(tree.text);
  expect(tree.text.length).toBeLessThanOrEqual(200);
});

/** Nothing behind the # is no link at all, and browsers drop line breaks from an address. */
const broken = brokenDocuments.filter(
  ({ kind, text }) => kind === "link" && text !== "" && !text.includes("\n"),
);

test("opens every broken link of the table, is told what is wrong, and keeps the page", async ({
  corridor,
  page,
}) => {
  expect(broken.length).toBeGreaterThanOrEqual(20);
  await corridor.maze.click({ column: 2, row: 6 });
  const before = await corridor.shareLink({ withProgram: true });
  for (const { name, text, code } of broken) {
    if (code === undefined) throw new Error(`${name} has no code`);
    await page.evaluate((hash) => (location.hash = hash), asFragment(text));
    await expect(corridor.message(sentences[code]), name).toBeVisible();
    expect(new URL(page.url()).hash, name).toBe("");
    await corridor.dismissMessages();
  }
  expect(await corridor.shareLink({ withProgram: true })).toBe(before);
});

test("comes with a cut link, is told so, and opens an empty maze instead", async ({
  corridor,
  openWindow,
}) => {
  const link = await corridor.shareLink({ withProgram: false });
  const reader = await openWindow();
  await reader.open(link.slice(0, -4));
  await expect(reader.message(sentences["cut-off"])).toBeVisible();
  await expect(reader.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  await reader.messages.getByRole("button", { name: "Open an empty maze" }).click();
  await expect(reader.mazeMenu).toHaveAccessibleName("New maze, Maze menu");
  await expect(reader.message(sentences["cut-off"])).toBeHidden();
});

test("opens a robot's address in a browser and never shows its key", async ({ openWindow }) => {
  const { page } = await openWindow();
  await page.goto("/r/abcdefghijklmnop#a-key-that-nobody-should-see");
  await expect(page.getByRole("alert")).toContainText("A part of this link is missing");
  expect(page.url()).not.toContain("key");
});

function fragmentOf(link: string): string {
  return new URL(link).hash.slice(1);
}

/** A text as a browser lets it stand behind the #. */
function asFragment(text: string): string {
  return text.startsWith("#") ? `#${text}` : text;
}
