/** Maze files of micromouse contests: opening, the check, the marks over the maze, and saving. */
import { readFile } from "node:fs/promises";
import {
  readTextMaze,
  writeContestMaze,
  type ContestFormat,
  type MazeDocument,
} from "@corridor/maze";
import type { Page } from "playwright/test";
import { SAMPLE } from "../packages/maze/src/contest/testing/sample-contest.ts";
import { expect, test } from "./fixtures.ts";
import type { ChosenFile, CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

function mazeOf(text: string): MazeDocument {
  const read = readTextMaze(text, "Final");
  if (!read.ok) throw new Error(JSON.stringify(read.problems));
  return read.value;
}

/** 16 x 16 cells: one long corridor to the goal. */
const sixteen = mazeOf(
  `${"o---".repeat(16)}o\n${`${"|   ".repeat(16)}|\n${"o   ".repeat(16)}o\n`.repeat(15)}|   ${"    ".repeat(15)}|\n${"o---".repeat(16)}o`,
);

function contentOf(maze: MazeDocument, format: ContestFormat): Buffer {
  const written = writeContestMaze(maze, format);
  if (!written.ok) throw new Error(written.refusal.problem.expected);
  return Buffer.from(written.value);
}

async function open(corridor: CorridorPage, name: string, content: Buffer | string): Promise<void> {
  await corridor.openFiles([chosen(name, content)]);
}

function chosen(name: string, content: Buffer | string): ChosenFile {
  return { name, mimeType: "application/octet-stream", buffer: Buffer.from(content) };
}

async function openSaveDialog(corridor: CorridorPage) {
  await corridor.mazeMenu.click();
  await corridor.dialog("Maze menu").getByRole("button", { name: "Save for micromouse…" }).click();
  return corridor.dialog("Save for micromouse");
}

const marksOf = (page: Page) => page.locator("svg[data-marks] path");

async function showsWhyGoalIsMissed(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await open(corridor, "final.map", `${SAMPLE.replaceAll("\n", "\r\n")}\r\nFinal 2019\r\n`);
  await expect(corridor.mazeMenu).toHaveAccessibleName("final, Maze menu");
  const check = corridor.message("Contest maze, 6 × 6 cells.");
  await expect(check).toContainText("Shortest path to the goal: 10 cells.");
  await expect(check).toContainText("A robot that follows a wall cannot reach this goal.");
  await expect(check).toContainText("The maze keeps all contest rules.");
  await expect(marksOf(page)).toHaveCount(0);
  const show = corridor.messages.getByRole("button", { name: "Show why" });
  await show.focus();
  await page.keyboard.press("Enter");
  await expect(corridor.message("The marked walls are around the goal.")).toBeVisible();
  await expect(marksOf(page)).toHaveCount(3);
  await expectNoAxeViolations(page, "marks of a contest maze");
  await corridor.messages.getByRole("button", { name: "Hide the marks" }).click();
  await expect(marksOf(page)).toHaveCount(0);
}

async function removesMarks(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  // The same maze is open from the step before.
  await open(corridor, "final.map", SAMPLE);
  await corridor.messages.getByRole("button", { name: "Show why" }).click();
  await expect(marksOf(page)).toHaveCount(3);
  await corridor.maze.click({ column: 4, row: 4 });
  await expect(marksOf(page)).toHaveCount(0);
  await open(corridor, "final.map", SAMPLE);
  await corridor.messages.getByRole("button", { name: "Show why" }).click();
  await expect(marksOf(page)).toHaveCount(3);
  await corridor.choosePreset("Spiral");
  await expect(marksOf(page)).toHaveCount(0);
}

async function namesBrokenRules(corridor: CorridorPage): Promise<void> {
  await open(corridor, "cells.num", "0 0 0 1 1 1\n0 1 1 1 0 1\n1 0 1 1 1 1\n1 1 1 1 1 1\n");
  const check = corridor.message("Contest maze, 2 × 2 cells.");
  await expect(check).toContainText("no path leads to some cells (2)");
  await open(corridor, "walls.map", "o---o---o\n|   | G |\no   o---o\n| S |   |\no---o---o\n");
  await expect(corridor.message("No path leads to the goal.")).toBeVisible();
}

async function opensAndSavesFormats(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await open(corridor, "any-name.bin", contentOf(sixteen, "maz"));
  await expect(corridor.mazeMenu).toHaveAccessibleName("any-name, Maze menu");
  await expect(corridor.message("Contest maze, 16 × 16 cells.")).toBeVisible();
  await expect(corridor.maze.grid).toHaveAttribute("aria-colcount", "33");
  for (const format of ["map", "num", "maz"] as const) {
    const dialog = await openSaveDialog(corridor);
    if (format === "map") await expectNoAxeViolations(page, "saving a contest maze");
    const download = page.waitForEvent("download");
    await dialog.getByRole("button", { name: `Save as .${format}` }).click();
    expect((await download).suggestedFilename()).toBe(`any-name.${format}`);
    expect(await readFile(await (await download).path())).toEqual(contentOf(sixteen, format));
    await expect(dialog).toBeHidden();
  }
}

async function cannotSave(corridor: CorridorPage): Promise<void> {
  const dialog = await openSaveDialog(corridor);
  await expect(dialog.getByRole("button", { name: "Save as .maz" })).toBeDisabled();
  await expect(dialog.getByRole("button", { name: "Save as .num" })).toHaveAccessibleDescription(
    /^(?:The start must|This is not a maze of posts|The goal must)/,
  );
  await corridor.page.keyboard.press("Escape");
}

async function reportsBrokenFiles(corridor: CorridorPage): Promise<void> {
  for (const { name, content, problem } of [
    { name: "a.map", content: "o---o\n| S |", problem: "line 3Found: nothing" },
    { name: "b.map", content: "o---o---o\n| S   x |\no---o---o", problem: "line 2, column 7" },
    { name: "c.num", content: "0 0 1 1 1", problem: "line 1" },
    { name: "d.num", content: "0 0 1 1 1 1\n0 0 1 1 1 1", problem: "each cell once" },
    { name: "e.maz", content: Buffer.alloc(256), problem: "byte 0Found: no wall in the south" },
    { name: "f.maz", content: Buffer.alloc(255), problem: "Expected: " },
  ]) {
    await open(corridor, name, content);
    const dialog = corridor.dialog("This file cannot be opened");
    await expect(dialog.getByRole("region", { name })).toContainText(problem);
    await corridor.page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
    await expect(corridor.mazeMenu).toHaveAccessibleName("Long way round, Maze menu");
  }
}

test("opens, checks and saves the maze files of contests", async ({ corridor }) => {
  const step = (title: string, check: (page: CorridorPage) => Promise<void>) =>
    test.step(title, async () => {
      await check(corridor);
      await corridor.dismissMessages();
    });
  await step("shows why a maze cannot be saved in a format", cannotSave);
  await step(
    "reports what is wrong with broken contest files, and changes nothing",
    reportsBrokenFiles,
  );
  await step("names the rules that a maze breaks, and no path", namesBrokenRules);
  await step("shows why a wall follower misses the goal, by keyboard", showsWhyGoalIsMissed);
  await step("removes the marks with an edit, another maze, and a dismissed message", removesMarks);
  await step(
    "opens a binary file by its content, and saves the maze in every format",
    opensAndSavesFormats,
  );
});

test("shows the check and the marks on a phone", async ({ openWindow }) => {
  const phone = await openWindow({
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
  });
  await phone.open();
  await phone.openFiles([chosen("final.map", SAMPLE)], "tap");
  await phone.messages.getByRole("button", { name: "Show why" }).tap();
  await expect(marksOf(phone.page)).toHaveCount(3);
});
