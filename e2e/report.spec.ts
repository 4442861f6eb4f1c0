/** The report of a class: the numbers of the thesis of 2013 from its own tables. */
import { readFileSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import type { Locator, Page } from "playwright/test";
import { expect, test } from "./fixtures.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { horizontalOverflow, smallTouchTargets } from "./support/layout.ts";
import { smallestPhone } from "./support/phone.ts";
import { wideWindow } from "./support/window-sizes.ts";

test.use(wideWindow);

const paper = (name: string) =>
  fileURLToPath(new URL(`../packages/report/src/testing/${name}`, import.meta.url));
const paperFiles = [paper("table-10-times.csv"), paper("table-9-survey.csv")];

/** Writes a table into the folder of the test. @returns its path: the browser reads it from there */
function csv(name: string, text: string): string {
  const path = test.info().outputPath(name);
  writeFileSync(path, text);
  return path;
}

async function choose(page: Page, files: string[]): Promise<void> {
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Choose CSV files" }).click();
  await (await chooser).setFiles(files);
}

async function openReports(page: Page): Promise<void> {
  await page.goto("/teach");
  await page.getByRole("link", { name: /^Reports/ }).click();
  await expect(page.getByRole("heading", { name: "Reports" })).toBeVisible();
}

/** The cells of the row whose name begins so. */
function cellsOf(page: Page, name: string): Locator {
  return page.getByRole("row", { name: new RegExp(`^${name}`) }).getByRole("cell");
}

test("shows the paper's numbers from the paper's files, saves and opens tables, and explains an invalid one", async ({
  page,
}) => {
  await openReports(page);
  await choose(page, paperFiles);
  await test.step("shows the paper's numbers from the paper's files", () => expectNumbers(page));
  await test.step("saves one table, and opens it again with the same report", () =>
    saveAndOpen(page));
  await test.step("counts the mistakes that the teacher types", () => typeMistakes(page));
  const remove = page.getByRole("button", { name: "Remove files" });
  await remove.click();
  await test.step("states for each number of which students it is", () => stateStudents(page));
  await remove.click();
  await test.step("explains an invalid table, and keeps the open report", () => refuse(page));
});

async function expectNumbers(page: Page): Promise<void> {
  await expect(page.getByText("Students: 28")).toBeVisible();
  await expect(cellsOf(page, "right wall")).toHaveText([
    "28 of 28 (100%)",
    "5:17",
    "4:30",
    "3:53",
    "0:30",
    "14:00",
    "2 lines (5 in the paper)",
  ]);
  await expect(cellsOf(page, "farthest distance")).toHaveText([
    "28 of 28 (100%)",
    "3:48",
    "3:53",
    "2:15",
    "0:45",
    "9:30",
    "3 lines (7 in the paper)",
  ]);
  await expect(page.getByText("Table 6 of the paper prints 3:38.")).toBeVisible();
  const bars = page.getByRole("list", { name: "Time of each student: right wall" });
  await expect(bars.getByRole("listitem")).toHaveCount(28);
  await expect(bars.getByRole("listitem").last()).toHaveText("Student 28: 14:00");
  // The rows of table 10.
  const rows = page.getByRole("region", { name: "Each student" }).getByRole("row");
  await expect(rows).toHaveCount(29);
  await expect(rows.nth(3)).toHaveText(/^3\s*0:40\s*6:00$/);
  await expect(rows.last()).toHaveText(/^28\s*14:00\s*4:00$/);
}

async function saveAndOpen(page: Page): Promise<void> {
  const tables = page.getByRole("table");
  await expect(tables).toHaveCount(3);
  const shown = await tables.allInnerTexts();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save as CSV" }).click();
  const saved = test.info().outputPath("report.csv");
  await (await download).saveAs(saved);
  expect(readFileSync(saved, "utf8")).toMatch(/^\uFEFFstudent,task,seconds,/);
  await page.getByRole("button", { name: "Remove files" }).click();
  await expect(tables).toHaveCount(0);
  await choose(page, [saved]);
  await expect(tables).toHaveCount(3);
  expect(await tables.allInnerTexts()).toEqual(shown);
}

async function typeMistakes(page: Page): Promise<void> {
  const mistakes = page.getByRole("group", { name: "Students with a mistake" });
  const controlFlow = "How much did the simulator help you see how a program runs";
  const navigation = "How much did the simulator help you see how a robot finds its way";
  await mistakes.getByLabel(controlFlow).fill("1");
  await mistakes.getByLabel(navigation).fill("3");
  await expect(cellsOf(page, controlFlow)).toHaveText([
    "0",
    "3",
    "5",
    "9",
    "11",
    "0",
    "4.0",
    "3.6%",
  ]);
  await expect(cellsOf(page, navigation)).toHaveText([
    "0",
    "1",
    "4",
    "9",
    "14",
    "0",
    "4.3",
    "10.7%",
  ]);
  await expectNoAxeViolations(page, "a report");
}

async function stateStudents(page: Page): Promise<void> {
  const rows = ["Juniper,One,60,2", "Comet,One,90,0", "Comet,Two,,4", "Pixel,,,"];
  await choose(page, [
    csv("8b-corners.csv", ["student,task,seconds,attempts", ...rows].join("\n")),
  ]);
  await expect(page.getByRole("heading", { name: "8b-corners.csv" })).toBeVisible();
  await expect(page.getByText("Students: 3")).toBeVisible();
  const row = (table: string, name: string) =>
    page.getByRole("region", { name: table }).getByRole("row", { name }).getByRole("cell");
  const time = ["1:15", "1:15", "0:15", "1:00", "1:30"];
  await expect(row("Time to solve", "One")).toHaveText(["2 of 3 (66.7%)", ...time, "–"]);
  await expect(row("Time to solve", "Two").first()).toHaveText("0 of 3 (0%)");
  const unknown = ["–", "–", "–", "–", "–"];
  await expect(row("Mean for each student", "One")).toHaveText(["2 of 3", "1", ...unknown, "–"]);
  await expect(row("Mean for each student", "Two")).toHaveText([
    "1 of 3",
    "too few",
    ...unknown,
    "–",
  ]);
  await expect(row("Each student", "Pixel").first()).toHaveText("–");
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save as CSV" }).click();
  expect((await download).suggestedFilename()).toBe("8b-corners.csv");
}

async function refuse(page: Page): Promise<void> {
  await choose(page, [csv("one.csv", "student,task,seconds\nJuniper,1,60\n")]);
  await expect(page.getByText("1 student: too few for a mean.")).toBeVisible();
  // Few students have a name and a time beside their bars, and a row each.
  await expect(
    page.getByRole("list", { name: "Time of each student: 1" }).getByRole("listitem"),
  ).toHaveText(["Juniper1:00"]);
  await expect(page.getByRole("row", { name: "Juniper 1:00" })).toBeVisible();
  await choose(page, [
    csv("text.csv", "hello world\n"),
    csv("six.csv", "navigation\n5\n6\n"),
    csv("again.csv", "student,task,seconds\nJuniper,1,90\n"),
    csv("long.csv", `a_seconds\n${"1\n".repeat(100_000)}`),
    csv("large.csv", `a_seconds\n${"1\n".repeat(5_000_000)}`),
  ]);
  await expect(page.getByRole("alert").getByRole("listitem")).toHaveText([
    /text\.csv is not a table that Corridor can read\..*row 1: found the columns hello world/,
    /six\.csv is not.*row 3, navigation: found 6, expected an answer from 1/,
    /again\.csv is not.*found two rows of Juniper and 1/,
    /long\.csv is not.*found more than \d+ rows/,
    /large\.csv is bigger than 8 MB\..*choose another file/,
  ]);
  await expect(page.getByRole("row", { name: /^1 / })).toContainText("1:00");
}

test("scrolls tables inside the page on the smallest phone", async ({ openWindow }) => {
  const { page } = await openWindow(smallestPhone);
  await openReports(page);
  await choose(page, paperFiles);
  await expect(page.getByText("Students: 28")).toBeVisible();
  expect(await horizontalOverflow(page)).toEqual([]);
  expect(await smallTouchTargets(page)).toEqual([]);
  await expectNoAxeViolations(page, "a report on a phone");
});
