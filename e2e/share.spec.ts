/**
 * Sharing a maze as a link, from a teacher to a student, without changing the student's project.
 */
import { encodeLink } from "@corridor/link";
import { brokenDocuments } from "@corridor/link/testing";
import { generateTree } from "@corridor/maze";
import { expect, test } from "./fixtures.ts";
import { smallWindow, wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

const sentences = {
  empty: "This link is empty.",
  "unknown-version": "Corridor cannot open this link. Maybe a newer version made it.",
  "cut-off": "A part of this link is missing.",
  damaged: "This link was changed, so it cannot be opened.",
  "too-long": "This link is too long for Corridor.",
};

/** Excludes texts that are no link: an empty fragment, and line breaks, which browsers remove. */
const broken = brokenDocuments.filter(
  ({ kind, text }) => kind === "link" && text !== "" && !text.includes("\n"),
);

test("shares a maze, a large maze and a program with another user, and keeps the link in the address bar", async ({
  corridor,
  page,
  openWindow,
}) => {
  const recipient = await openWindow(smallWindow);

  await test.step("copies a link, from which another user opens the maze without the program", async () => {
    await corridor.maze.click({ column: 2, row: 6 });
    await corridor.program.loadAlgorithm("Left wall");
    await corridor.share.click();
    const dialog = corridor.dialog("Share this maze");
    await dialog.getByRole("button", { name: "Copy link" }).click();
    await expect(dialog.getByText("Link copied")).toBeAttached();
    const link = await page.evaluate(() => navigator.clipboard.readText());
    expect(link).toBe(await dialog.getByRole("textbox", { name: "Link" }).inputValue());
    await page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();

    await recipient.open(link);
    // A first-time visitor has no project to go back to.
    await expect(recipient.message(/^You opened a shared maze\.$/)).toBeVisible();
    await expect(recipient.messages.getByRole("button", { name: "Back to my maze" })).toHaveCount(
      0,
    );
    await recipient.maze.expectSquare({ column: 2, row: 6 }, "block");
    // The link contains no program, so the recipient still has the maze to solve.
    await expect(recipient.program.lines).toHaveCount(0);
    await expect(recipient.program.region.getByText("Get the robot to the goal.")).toBeVisible();
    // The link leaves the address, so that a reload keeps the recipient's edits.
    expect(new URL(recipient.page.url()).hash).toBe("");
  });

  await test.step("includes the program in the link on request", async () => {
    await corridor.maze.click({ column: 2, row: 6 });
    await corridor.maze.expectSquare({ column: 2, row: 6 }, "open");
    await corridor.program.loadAlgorithm("Farthest distance");
    await recipient.open(await corridor.shareLink({ withProgram: true }));
    await expect(recipient.program.name).toHaveValue("Farthest distance");
    await expect(recipient.program.lines).toHaveCount(3);
    await recipient.speed.selectOption("max");
    await recipient.run.click();
    await expect(recipient.runNote).toContainText("tick 2310");
  });

  await test.step("keeps the link in the address bar until a shared document changes", async () => {
    const link = await corridor.shareLink({ withProgram: false });
    expect(page.url()).toBe(link);
    await corridor.dismissMessages();
    // The program is not part of the link: it can change, and a reload keeps both.
    await corridor.program.otherwise.selectOption("reverse");
    await expect(corridor.saveState).toHaveText("Saved on this device");
    await corridor.reload();
    expect(page.url()).toBe(link);
    await expect(corridor.program.otherwise).toHaveValue("reverse");
    await expect(corridor.messages.getByRole("listitem")).toHaveCount(0);
    await corridor.maze.click({ column: 4, row: 6 });
    await expect(page).toHaveURL(/\/$/);
    const changed = await corridor.shareLink({ withProgram: false });
    expect(page.url()).toBe(changed);
    await recipient.open(page.url());
    await recipient.maze.expectSquare({ column: 4, row: 6 }, "block");
  });

  await test.step("creates a link of at most 200 characters for a maze of 33 by 33 squares", async () => {
    await corridor.maze.button("Resize").click();
    const dialog = corridor.dialog("Resize the maze");
    await dialog.getByRole("textbox", { name: "Columns" }).fill("33");
    await dialog.getByRole("textbox", { name: "Rows" }).fill("33");
    await dialog.getByRole("button", { name: "Resize maze" }).click();
    await expect(corridor.maze.grid).toHaveAttribute("aria-colcount", "33");
    const resized = await corridor.shareLink({ withProgram: false });
    expect(fragmentOf(resized).length).toBeLessThanOrEqual(200);

    const big = generateTree({ columns: 33, rows: 33, seed: 2, name: "Big" });
    const tree = encodeLink({ maze: big });
    if (!tree.ok) throw new Error(tree.code);
    await recipient.open(`/#${tree.text}`);
    await expect(recipient.maze.grid).toHaveAttribute("aria-colcount", "33");
    const link = await recipient.shareLink({ withProgram: false });
    expect(fragmentOf(link)).toBe(tree.text);
    expect(tree.text.length).toBeLessThanOrEqual(200);
  });
});

test("opens links in an open page: pasted, from the history, from the address, and reports broken ones", async ({
  corridor,
  page,
}) => {
  const paste = async (text: string): Promise<void> => {
    await page.evaluate((copied) => navigator.clipboard.writeText(copied), text);
    await page.keyboard.press("ControlOrMeta+V");
  };

  await test.step("opens a pasted link of the page's own origin", async () => {
    await corridor.choosePreset("Spiral");
    const link = await corridor.shareLink({ withProgram: false });
    await corridor.choosePreset("Tree");
    await paste(`${link}\n`);
    await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
    await expect(page).toHaveURL("/");
  });

  await test.step("goes back in browser history to a shared maze while another link is open", async () => {
    await corridor.choosePreset("Comb");
    const other = await corridor.shareLink({ withProgram: false });
    await corridor.choosePreset("Spiral");
    await corridor.shareLink({ withProgram: false });
    await paste(other);
    await expect(corridor.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
    await page.goBack();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  });

  await test.step("opens a link in the address", async () => {
    await corridor.choosePreset("Tree");
    const link = await corridor.shareLink({ withProgram: false });
    await corridor.choosePreset("Comb");
    await corridor.dismissMessages();
    await page.evaluate((hash) => (location.hash = hash), new URL(link).hash);
    await expect(corridor.mazeMenu).toHaveAccessibleName("Tree, Maze menu");
    await expect(corridor.message("You opened a shared maze.")).toBeVisible();
  });

  await test.step("reports the error of every broken link of the table, and changes nothing", async () => {
    expect(broken.length).toBeGreaterThanOrEqual(20);
    await corridor.maze.click({ column: 2, row: 6 });
    const before = await corridor.shareLink({ withProgram: true });
    await corridor.dismissMessages();
    for (const { name, text, code } of broken) {
      if (code === undefined) throw new Error(`${name} has no code`);
      await page.evaluate((hash) => (location.hash = hash), asFragment(text));
      await expect(corridor.message(sentences[code]), name).toBeVisible();
      expect(new URL(page.url()).hash, name).toBe("");
      await corridor.dismissMessages();
    }
    expect(await corridor.shareLink({ withProgram: true })).toBe(before);
  });
});

test("opens links on the first visit, stores the user's own project, and returns to it", async ({
  openWindow,
}) => {
  const recipient = await openWindow(smallWindow);
  const tree = encodeLink({
    maze: generateTree({ columns: 11, rows: 7, seed: 2, name: "Shared" }),
  });
  if (!tree.ok) throw new Error(tree.code);
  const link = `/#${tree.text}`;

  await test.step("opens a robot's address without displaying its key", async () => {
    const { page } = recipient;
    await page.goto("/r/abcdefghijklmnop#a-key-that-nobody-should-see");
    await expect(page.getByRole("alert")).toContainText("A part of this link is missing");
    expect(page.url()).not.toContain("key");
  });

  await test.step("reports a truncated link, and opens an empty maze on request", async () => {
    await recipient.open(link.slice(0, -4));
    await expect(recipient.message(sentences["cut-off"])).toBeVisible();
    await expect(recipient.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
    await recipient.messages.getByRole("button", { name: "Open an empty maze" }).click();
    await expect(recipient.mazeMenu).toHaveAccessibleName("New maze, Maze menu");
    await expect(recipient.message(sentences["cut-off"])).toBeHidden();
    await recipient.dismissMessages();
  });

  await test.step("stores the user's own project, and returns to it", async () => {
    await recipient.maze.click({ column: 2, row: 6 });
    await expect(recipient.saveState).toHaveText("Saved on this device");
    await recipient.open(link);
    await expect(recipient.mazeMenu).toHaveAccessibleName("Shared, Maze menu");
    await expect(
      recipient.message("You opened a shared maze. Your own maze and program are saved."),
    ).toBeVisible();
    await recipient.messages.getByRole("button", { name: "Back to my maze" }).click();
    await expect(recipient.mazeMenu).toHaveAccessibleName("New maze, Maze menu");
    await recipient.maze.expectSquare({ column: 2, row: 6 }, "block");

    // The maze menu lists both projects, and the shared one is unchanged.
    await recipient.mazeMenu.click();
    await recipient
      .dialog("Maze menu")
      .getByRole("button", { name: "Open Shared", exact: true })
      .click();
    await expect(recipient.mazeMenu).toHaveAccessibleName("Shared, Maze menu");
  });
});

function fragmentOf(link: string): string {
  return new URL(link).hash.slice(1);
}

/** The text as a browser represents it in a fragment. */
function asFragment(text: string): string {
  return text.startsWith("#") ? `#${text}` : text;
}
