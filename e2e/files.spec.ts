/** Opening and saving files: documents, text mazes and pictures, by menu, drop and paste. */
import { readFile } from "node:fs/promises";
import { mazePresets, parseMaze, writeTextMaze } from "@corridor/maze";
import { programPresets } from "@corridor/program";
import type { Download, Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import type { ChosenFile, CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

const spiral = mazePresets.find(({ id }) => id === "spiral")?.maze;
const comb = mazePresets.find(({ id }) => id === "comb")?.maze;
const twoRooms = mazePresets.find(({ id }) => id === "two-rooms")?.maze;
const leftWall = programPresets.find(({ id }) => id === "left-wall")?.program;
if (
  spiral === undefined ||
  comb === undefined ||
  twoRooms === undefined ||
  leftWall === undefined
) {
  throw new Error("a preset is missing");
}

const spiralFile = { name: "spiral.maze.json", text: JSON.stringify(spiral) };
const combFile = { name: "comb.maze.json", text: JSON.stringify(comb) };
const leftWallFile = { name: "left.program.json", text: JSON.stringify(leftWall) };

interface TextFile {
  name: string;
  text: string;
}

/** Drags files over the page. @returns functions that drop them or leave the page */
async function dragOver(page: Page, files: readonly TextFile[]) {
  const transfer = await page.evaluateHandle((list) => {
    const data = new DataTransfer();
    for (const { name, text } of list) data.items.add(new File([text], name));
    return data;
  }, files);
  const body = page.locator("body");
  await body.dispatchEvent("dragenter", { dataTransfer: transfer });
  await body.dispatchEvent("dragover", { dataTransfer: transfer });
  return {
    drop: () => body.dispatchEvent("drop", { dataTransfer: transfer }),
    leave: () => body.dispatchEvent("dragleave", { dataTransfer: transfer }),
  };
}

async function paste(page: Page, text: string): Promise<void> {
  await page.evaluate((content) => navigator.clipboard.writeText(content), text);
  await page.keyboard.press("ControlOrMeta+V");
}

/** Selects an entry of the maze menu that saves a file. */
async function save(corridor: CorridorPage, entry: string): Promise<Download> {
  await corridor.mazeMenu.click();
  const download = corridor.page.waitForEvent("download");
  await corridor.dialog("Maze menu").getByRole("button", { name: entry, exact: true }).click();
  return download;
}

function chosen({ name, text }: TextFile): ChosenFile {
  return { name, mimeType: "application/json", buffer: Buffer.from(text) };
}

/** What the page shows while files are dragged across it. */
const dropHint = (page: Page): Locator =>
  page.getByText("Drop a maze, a program, a run or a lesson to open it");

test("opens dropped and pasted mazes and programs, and nothing else", async ({
  corridor,
  page,
  relay,
}) => {
  await test.step("a file that is dragged across the page", async () => {
    const drag = await dragOver(page, [spiralFile]);
    await expect(dropHint(page)).toBeVisible();
    await drag.leave();
    await expect(dropHint(page)).toBeHidden();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  });

  await test.step("a pasted text that is no maze", async () => {
    await corridor.run.focus();
    await paste(page, "Dear Anna, see you at eight.");
    await expect(corridor.message("The text you pasted is not a maze")).toBeVisible();
    await expect(page.getByRole("dialog")).toBeHidden();
    await expect(corridor.run).toBeFocused();
  });

  await test.step("a pasted address without a document", async () => {
    await corridor.run.focus();
    await paste(page, `${relay}/foo`);
    await expect(corridor.message("The text you pasted is not a maze")).toBeVisible();
    await paste(page, `${relay}/r/AAAAAAAAAAAAAAAAAAAAAA#drv_AAAAAAAAAAAAAAAAAAAAAA`);
    await expect(corridor.message("This address is for a script.")).toBeVisible();
    await expect(page).toHaveURL(`${relay}/`);
  });

  await test.step("a pasted picture", async () => {
    await page.evaluate(async () => {
      const canvas = document.createElement("canvas");
      canvas.width = canvas.height = 20;
      canvas.getContext("2d")?.fillRect(0, 0, 9, 9);
      const png = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve));
      if (png === null) throw new Error("no picture");
      await navigator.clipboard.write([new ClipboardItem({ "image/png": png })]);
    });
    await page.keyboard.press("Control+V");
    const dialog = corridor.dialog("This file cannot be opened");
    await expect(dialog.getByText("Found: a picture")).toBeVisible();
    await expect(dialog).toContainText("A maze cannot be read from a picture.");
    await expect(dialog).not.toContainText("text editor");
    await expect(dialog).not.toContainText("The whole file");
    await page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
  });

  await test.step("a dropped maze, with an empty program while the user has written none", async () => {
    await (await dragOver(page, [spiralFile])).drop();
    await expect(
      corridor.message("Your program is empty: get the robot to the goal."),
    ).toBeVisible();
    await expect(corridor.program.lines).toHaveCount(0);
  });

  await test.step("a pasted text maze", async () => {
    await corridor.run.focus();
    await paste(page, "#######\r\n#>....#\r\n#####G#\r\n#######");
    await expect(corridor.message("“Clipboard” is open. Your program is empty")).toBeVisible();
    await expect(corridor.maze.grid).toHaveAttribute("aria-colcount", "7");
    await expect(corridor.robotPose).toHaveText("Robot at 150, 150, facing right");
    await corridor.maze.expectSquare({ column: 5, row: 2 }, "open, goal");
  });

  await test.step("a pasted micromouse maze, and a program as JSON", async () => {
    await corridor.run.focus();
    await paste(page, "o---o---o\n|     G |\no   o---o\n| S |   |\no---o---o\n");
    await expect(corridor.robotPose).toHaveText("Robot at 150, 350, facing up");
    await paste(page, leftWallFile.text);
    await expect(corridor.program.name).toHaveValue("Left wall");
    await expect(corridor.maze.grid).toHaveAttribute("aria-colcount", "5");
  });
});

test("opens files, lists the errors of broken ones, and saves the maze and the program", async ({
  corridor,
  page,
}) => {
  await corridor.maze.click({ column: 2, row: 6 });
  await test.step("a dropped maze, with the program of the user, and the way back", async () => {
    await corridor.program.nameAsOwn();
    const drag = await dragOver(page, [spiralFile]);
    await expect(dropHint(page)).toBeVisible();
    await drag.drop();
    await expect(dropHint(page)).toBeHidden();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
    await expect(corridor.message("“Spiral” is open, with your program.")).toBeVisible();
    await expect(corridor.program.name).toHaveValue("Mine");
    // The previous maze is stored with its edit.
    await corridor.messages.getByRole("button", { name: "Back to my maze" }).click();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
    await corridor.maze.expectSquare({ column: 2, row: 6 }, "block");
  });

  await test.step("broken files change nothing", async () => {
    const broken = { ...spiral, name: 7, start: { ...spiral.start, heading: "up" } };
    await corridor.openFiles(
      [
        { name: "broken.maze.json", text: JSON.stringify(broken) },
        { name: "drawn.txt", text: "####\n#S?#\n####" },
        { name: "words.txt", text: "if right > 60 then right 90\notherwise forward" },
        leftWallFile,
      ].map(chosen),
    );
    const dialog = corridor.dialog("These files cannot be opened");
    await expect(dialog.getByText("Nothing changed.")).toBeVisible();
    const first = dialog.getByRole("region", { name: "broken.maze.json" });
    await expect(first.getByRole("listitem")).toHaveCount(2);
    await expect(first).toContainText('start.headingFound: "up"Expected: one of north, east');
    const second = dialog.getByRole("region", { name: "drawn.txt" });
    const third = dialog.getByRole("region", { name: "words.txt" });
    await expect(third).toContainText("The whole file");
    await expect(third).toContainText('Found: "if right > 60 then right 90"');
    await expect(third).toContainText("Expected: a program as Corridor saves it");
    await expect(second).toContainText('line 2, column 3Found: "?"Expected: # for a block');
    await expectNoAxeViolations(page, "broken files");
    await page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
    await expect(corridor.program.name).toHaveValue("Mine");
    await corridor.maze.expectSquare({ column: 2, row: 6 }, "block");
  });

  await test.step("the maze as a file and as text, and the program", async () => {
    const download = await save(corridor, "Save maze");
    expect(download.suggestedFilename()).toBe("long-way-round.maze.json");
    const text = await readFile(await download.path(), "utf8");
    expect(parseMaze(JSON.parse(text)).ok).toBe(true);
    const program = await save(corridor, "Save program");
    expect(program.suggestedFilename()).toBe("mine.program.json");
    expect(JSON.parse(await readFile(await program.path(), "utf8"))).toMatchObject({
      format: "corridor/program",
      name: "Mine",
    });
    await corridor.choosePreset("Two rooms");
    const drawing = await save(corridor, "Save maze as text");
    expect(drawing.suggestedFilename()).toBe("two-rooms.txt");
    expect(await readFile(await drawing.path(), "utf8")).toBe(writeTextMaze(twoRooms));
    await corridor.openFiles([chosen({ name: download.suggestedFilename(), text })]);
    await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
    await corridor.maze.expectSquare({ column: 2, row: 6 }, "block");
  });

  await test.step("text in a field stays text", async () => {
    await corridor.program.name.fill("");
    await paste(page, "#S.G#");
    await expect(corridor.program.name).toHaveValue("#S.G#");
    await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  });

  await test.step("a maze and a program together, as one project", async () => {
    await corridor.openFiles([leftWallFile, combFile].map(chosen));
    await expect(corridor.message("“Comb” and “Left wall” are open.")).toBeVisible();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Comb, Maze menu");
    await expect(corridor.program.name).toHaveValue("Left wall");
  });
});

test("saves a picture and the run, and opens the run again", async ({ corridor, page }) => {
  await corridor.speed.selectOption("max");
  await corridor.run.click();
  await expect(corridor.runNote).toContainText("tick 2380");
  await test.step("a picture", async () => {
    const light = await page.evaluate(() =>
      getComputedStyle(document.documentElement).getPropertyValue("--live-soft").trim(),
    );
    const openDialog = async () => {
      await corridor.mazeMenu.click();
      await corridor
        .dialog("Maze menu")
        .getByRole("button", { name: /^Save picture/ })
        .click();
      return corridor.dialog("Save picture");
    };
    let dialog = await openDialog();
    await expect(dialog.getByRole("img", { name: "Picture of “Long way round”" })).toBeVisible();
    await expectNoAxeViolations(page, "picture");
    const asPng = page.waitForEvent("download");
    await dialog.getByRole("button", { name: "Save as PNG" }).click();
    const png = await asPng;
    expect(png.suggestedFilename()).toBe("long-way-round.png");
    const bytes = await readFile(await png.path());
    expect(bytes.subarray(1, 4).toString("latin1")).toBe("PNG");
    // 11 squares of 80 px and the rulers, twice as large.
    expect(bytes.readUInt32BE(16)).toBe(2 * (11 * 80 + 64));

    dialog = await openDialog();
    await dialog.getByRole("checkbox", { name: "Rulers in cm" }).uncheck();
    const asSvg = page.waitForEvent("download");
    await dialog.getByRole("button", { name: "Save as SVG" }).click();
    const svg = await readFile(await (await asSvg).path(), "utf8");
    expect(svg).toContain("<title>Long way round</title>");
    expect(svg).not.toContain(">1100</text>");
    // The trail has the light theme's colour, although the page is dark now.
    expect(svg).toContain(`stroke="${light}"`);
  });

  await test.step("the run as a file", async () => {
    const download = await save(corridor, "Save run");
    expect(download.suggestedFilename()).toBe("long-way-round.run.json");
    const text = await readFile(await download.path(), "utf8");

    await corridor.choosePreset("Spiral");
    await (await dragOver(page, [{ name: "a.run.json", text }])).drop();
    await expect(corridor.message(/^A recorded run/)).toBeVisible();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
    // A run with a wrong digest is rejected, and the project stays open.
    const changed = JSON.stringify({ ...JSON.parse(text), digest: "0".repeat(64) });
    await (await dragOver(page, [{ name: "b.run.json", text: changed }])).drop();
    await expect(
      corridor.dialog("This file cannot be opened").getByRole("region", { name: "b.run.json" }),
    ).toBeVisible();
  });
});

test("opens and saves files on a phone", async ({ openWindow }) => {
  const phone = await openWindow({
    viewport: { width: 320, height: 700 },
    hasTouch: true,
    isMobile: true,
  });
  await phone.open();
  await phone.openFiles([chosen({ name: "x.json", text: spiralFile.text })], "tap");
  await expect(phone.mazeMenu).toHaveAccessibleName("Spiral, Maze menu");
  await phone.page.getByRole("button", { name: "More" }).tap();
  const download = phone.page.waitForEvent("download");
  await phone.dialog("More").getByRole("button", { name: "Save program" }).tap();
  expect((await download).suggestedFilename()).toBe("program.program.json");
});
