/** Printing: worksheets, and mazes on sheets to glue together, measured in the PDF. */
import type { Locator, Page } from "playwright/test";
import { lessonOf, type ChallengeDocument } from "@corridor/challenge";
import { encodeLink } from "@corridor/link";
import { mazePresets } from "@corridor/maze";
import { expect, test } from "./fixtures.ts";
import type { CorridorPage } from "./pages/corridor-page.ts";
import { expectNoAxeViolations } from "./support/axe.ts";
import { chooseLanguage } from "./support/choose-language.ts";
import { linesOf, pagesOf } from "./support/pdf-lines.ts";
import { Texts } from "./support/texts.ts";
import { smallWindow } from "./support/window-sizes.ts";

test.use(smallWindow);

/** 10 cm in points. */
const RULER = 283.46;
const A4 = { width: 595.3, height: 841.9 };
const LETTER = { width: 612, height: 792 };

async function openPrint(corridor: CorridorPage): Promise<Locator> {
  await corridor.share.click();
  await corridor.page.getByRole("button", { name: "Print", exact: true }).click();
  const dialog = corridor.dialog("Print");
  await expect(dialog.getByRole("button", { name: "Print", exact: true })).toBeVisible();
  return dialog;
}

async function print(page: Page): Promise<Buffer> {
  return page.pdf({ preferCSSPageSize: true, printBackground: false });
}

/** Number of lines that are as long as a ruler of 10 cm. */
function rulersIn(pdf: Buffer): number {
  return linesOf(pdf).filter(
    ({ length, isHorizontal }) => isHorizontal && Math.abs(length - RULER) <= 1,
  ).length;
}

function expectPages(pdf: Buffer, count: number, size: { width: number; height: number }): void {
  const pages = pagesOf(pdf);
  expect(pages).toHaveLength(count);
  for (const { width, height } of pages) {
    expect(Math.abs(width - size.width)).toBeLessThan(1);
    expect(Math.abs(height - size.height)).toBeLessThan(1);
  }
}

/** Two mazes, of which the second is long: its sheet is on its side. */
function lessonOfTwoMazes(): string {
  const comb = mazePresets.find(({ id }) => id === "comb")?.maze;
  if (comb === undefined) throw new Error("no maze");
  const row = ".".repeat(30);
  const long = { ...comb, blocks: [row, row, row], start: { ...comb.start, column: 0, row: 0 } };
  const task: ChallengeDocument = {
    format: "corridor/challenge",
    version: 1,
    name: "Two mazes",
    words: { task: "Reach both goals with the same lines.", short: "Both goals", hints: [] },
    mazes: [comb, { ...long, goals: [{ column: 29, row: 2 }] }],
    program: null,
    goal: { kind: "reach" },
    allowed: {
      drivers: ["program"],
      lines: 6,
      conditions: null,
      actions: null,
      edits: ["lines"],
      maze: false,
    },
    checks: { bumps: 0, seconds: 60 },
    par: null,
  };
  const link = encodeLink({ lesson: lessonOf(task) });
  if (!link.ok) throw new Error(link.code);
  return link.text;
}

async function showsSheetsOnlyInPrint(page: Page, dialog: Locator): Promise<void> {
  await page.emulateMedia({ media: "print", colorScheme: "dark" });
  await expect(dialog).toBeHidden();
  const sheet = page.locator("body > div > article");
  await expect(sheet).toBeVisible();
  await expect(sheet).toHaveCSS("background-color", "rgb(255, 255, 255)");
  await expect(sheet).toHaveCSS("color", "rgb(17, 17, 17)");
  await page.emulateMedia({ media: "screen", colorScheme: "dark" });
  await expect(sheet).toBeHidden();
  await page.keyboard.press("Escape");
  await expect(dialog).toBeHidden();
  await expect(sheet).toHaveCount(0);
  await page.emulateMedia({ media: null, colorScheme: "light" });
}

async function hasRulersAndSquares(
  page: Page,
  dialog: Locator,
  { paper, size, pages }: { paper: string; size: typeof A4; pages: number },
): Promise<void> {
  const side = dialog.getByRole("textbox", { name: /One square is/ });
  await dialog.getByRole("radio", { name: paper }).check();
  await side.fill("5");
  await expect(dialog.getByText(`${pages} sheets`)).toBeVisible();
  const pdf = await print(page);
  expectPages(pdf, pages, size);
  expect(rulersIn(pdf)).toBeGreaterThanOrEqual(pages);
  // A square is 5 cm: the lines between the 11 columns are 35 cm high.
  const sides = linesOf(pdf).filter(({ length }) => Math.abs(length - 7 * 141.73) <= 1);
  expect(sides.length).toBeGreaterThanOrEqual(10);
  // With these squares, no line of the maze is as long as the ruler.
  await side.fill("7");
  const other = await print(page);
  expect(rulersIn(other)).toBe(pagesOf(other).length);
}

async function refusesTooManySheets(page: Page, dialog: Locator): Promise<void> {
  const side = dialog.getByRole("textbox", { name: /One square is/ });
  await side.fill("50");
  const refusal = dialog.getByRole("alert");
  await expect(refusal).toContainText(
    /This takes \d+ sheets\. Up to 60 work\. Type [\d.]+ cm or less\./,
  );
  await expect(dialog.getByRole("button", { name: "Print", exact: true })).toHaveCount(0);
  const [, most = ""] = /Type ([\d.]+) cm/.exec((await refusal.textContent()) ?? "") ?? [];
  await side.fill(most);
  await expect(dialog.getByRole("button", { name: "Print", exact: true })).toBeVisible();
  const pages = pagesOf(await print(page));
  expect(pages.length).toBeGreaterThan(40);
  expect(pages.length).toBeLessThanOrEqual(60);
}

async function previewsRightToLeft(page: Page): Promise<void> {
  const texts = Texts.load("ar");
  const word = texts.t("print.print");
  await chooseLanguage(page, Texts.load("en"), "ar");
  await page.getByRole("button", { name: texts.t("share.share") }).click();
  await page.getByRole("button", { name: word, exact: true }).click();
  const dialog = page.getByRole("dialog", { name: word });
  const sheet = dialog.locator("article");
  await expect(sheet).toHaveCSS("direction", "rtl");
  await expect(sheet).toBeInViewport({ ratio: 0.9 });
  await page.keyboard.press("Escape");
  await chooseLanguage(page, texts, "en");
}

async function printsBothMazes(corridor: CorridorPage): Promise<void> {
  const { page } = corridor;
  await page.evaluate((hash) => (location.hash = hash), lessonOfTwoMazes());
  await expect(page.getByText("Reach both goals with the same lines.")).toBeVisible();
  const dialog = await openPrint(corridor);
  await dialog.getByRole("radio", { name: "A4" }).check();
  await expect(dialog.getByText("2 sheets")).toBeVisible();
  const pdf = await print(page);
  const sizes = pagesOf(pdf).map(({ width, height }) => (width > height ? "lying" : "upright"));
  expect(sizes).toEqual(["upright", "lying"]);
  await dialog.getByRole("combobox", { name: "Maze" }).selectOption("1");
  await expect(dialog.getByText("1 sheet")).toBeVisible();
  expect(pagesOf(await print(page))).toHaveLength(1);
}

async function printsSavedLesson(page: Page): Promise<void> {
  await page.goto("/teach");
  await page.getByRole("link", { name: /^Make a lesson/ }).click();
  await page.getByRole("button", { name: /2013 study/ }).click();
  await expect(page.getByRole("heading", { name: "The 2013 study" })).toBeVisible();
  await page.goto("/teach");
  await page.getByRole("button", { name: "More for The 2013 study" }).click();
  await page.getByRole("button", { name: "Print", exact: true }).click();
  const dialog = page.getByRole("dialog", { name: "Print" });
  await dialog.getByRole("radio", { name: "Letter" }).check();
  await expect(dialog.getByText(/^\d+ sheets$/)).toBeVisible();
  const pages = pagesOf(await print(page));
  expect(pages.length).toBeGreaterThanOrEqual(6);
}

test("prints worksheets, and mazes on sheets to glue together", async ({ corridor, page }) => {
  await test.step("shows the printed sheets in black on white in the dark theme, and the page only on screen", async () => {
    await page.emulateMedia({ colorScheme: "dark" });
    await showsSheetsOnlyInPrint(page, await openPrint(corridor));
  });
  await test.step("previews the worksheet in a right-to-left language", () =>
    previewsRightToLeft(page));
  const dialog = await openPrint(corridor);
  await test.step("has no accessibility violations", async () => {
    await expectNoAxeViolations(page, "print a worksheet");
    await dialog.getByRole("radio", { name: "Big maze" }).check();
    await expectNoAxeViolations(page, "print a big maze");
  });
  for (const sheet of [
    { paper: "Letter", size: LETTER, pages: 6 },
    { paper: "A4", size: A4, pages: 8 },
  ]) {
    await test.step(`prints a maze with squares of 5 cm on ${sheet.paper}, with a ruler of 10 cm on each sheet`, () =>
      hasRulersAndSquares(page, dialog, sheet));
  }
  await test.step("prints on sheets on their side where that takes fewer", async () => {
    await dialog.getByRole("textbox", { name: /One square is/ }).fill("2");
    await expect(dialog.getByText("1 sheet", { exact: false })).toBeVisible();
    expectPages(await print(page), 1, { width: A4.height, height: A4.width });
  });
  await test.step("refuses more than 60 sheets, and says which squares fit", () =>
    refusesTooManySheets(page, dialog));
  await test.step("fits into 320 px", async () => {
    await page.setViewportSize({ width: 320, height: 640 });
    const overflow = await dialog.evaluate((each) => each.scrollWidth - each.clientWidth);
    expect(overflow).toBe(0);
    await page.setViewportSize(smallWindow.viewport);
    await page.keyboard.press("Escape");
    await expect(dialog).toBeHidden();
  });
  await test.step("prints a worksheet for each maze of a lesson, also on their side", () =>
    printsBothMazes(corridor));
  await test.step("prints a saved lesson of a teacher", () => printsSavedLesson(page));
});
